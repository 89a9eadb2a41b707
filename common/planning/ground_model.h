#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/planning/ground_task.h"
#include "common/planning/model.h"

namespace cell::planning {

/// A task as a Markov decision process; bit i of a state is atom i. Dead ends
/// are found by the delete relaxation in which every outcome can be chosen
/// (h_max); atoms that no action that can still apply depends on on the way to
/// the goal are cleared.
class GroundModel final : public Model {
 public:
  /// @throws std::invalid_argument for atoms that are not there and for
  /// probabilities that are negative or exceed 1 in sum
  explicit GroundModel(GroundTask task);
  ~GroundModel() override;

  const GroundTask& task() const { return task_; }
  std::vector<uint64_t> initial() const;
  /// The words of a state that has these atoms.
  std::vector<uint64_t> Pack(const std::vector<bool>& state) const;

  int num_words() const override { return num_words_; }
  bool IsGoal(Bits state) const override;
  void Expand(Bits state, Expansion* expansion) const override;
  std::string ActionName(int action) const override;
  Estimate Assess(std::span<uint64_t> state) const override;

 private:
  class Compiled;

  GroundTask task_;
  int num_words_ = 0;
  std::unique_ptr<Compiled> compiled_;
};

}  // namespace cell::planning
