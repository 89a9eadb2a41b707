#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cell::planning {

/// The bits of a state, in words of 64.
using Bits = std::span<const uint64_t>;

/// The actions that a state allows and where they lead, in flat arrays that
/// are used again from state to state.
class Expansion {
 public:
  struct Choice {
    int action;  ///< as Model::ActionName() knows it
    int first_outcome;
    int num_outcomes;
  };

  explicit Expansion(int num_words) : num_words_(num_words) {}

  void Clear();
  void BeginChoice(int action);
  /// An outcome of the last choice. Probabilities of a choice sum to 1; states
  /// may be equal. Returns the state's words to fill in, valid until the next
  /// call; they hold the words of `start`.
  std::span<uint64_t> AddOutcome(double probability, Bits start);

  const std::vector<Choice>& choices() const { return choices_; }
  double probability(int outcome) const {
    return probabilities_[static_cast<size_t>(outcome)];
  }
  Bits state(int outcome) const {
    return Bits(words_).subspan(static_cast<size_t>(outcome) * num_words_,
                                num_words_);
  }

 private:
  size_t num_words_;
  std::vector<Choice> choices_;
  std::vector<double> probabilities_;
  std::vector<uint64_t> words_;
};

/// What can be said of a state before its successors are known.
struct Estimate {
  /// The goal is reached with at most this probability; 0: a dead end.
  double max_probability = 1;
  /// No way to the goal has fewer actions.
  double least_actions = 0;
  /// How far the goal seems to be; only breaks ties.
  double distance = 0;
};

/// A Markov decision process with goal states, given by what its states allow.
/// Deterministic: equal states get equal answers.
class Model {
 public:
  Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  virtual ~Model() = default;

  /// Words of a state.
  virtual int num_words() const = 0;
  virtual bool IsGoal(Bits state) const = 0;
  /// Appends the choices of a state that is no goal, in a fixed order. Choices
  /// that cannot change the state may be left out.
  virtual void Expand(Bits state, Expansion* expansion) const = 0;
  virtual std::string ActionName(int action) const = 0;

  /// May also replace the state by one from which the goal is reached in
  /// exactly the same ways, e.g. without atoms that no longer matter.
  virtual Estimate Assess(std::span<uint64_t> state) const;
};

}  // namespace cell::planning
