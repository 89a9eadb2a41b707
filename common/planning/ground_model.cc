#include "common/planning/ground_model.h"

#include <stdexcept>
#include <utility>

#include "common/planning/packed_task.h"
#include "common/planning/relaxation.h"

namespace cell::planning {

class GroundModel::Compiled {
 public:
  explicit Compiled(const GroundTask& task) : packed(task), relaxation(task) {}
  PackedTask packed;
  Relaxation relaxation;
};

GroundModel::GroundModel(GroundTask task)
    : task_(std::move(task)), compiled_(std::make_unique<Compiled>(task_)) {
  num_words_ = compiled_->packed.num_words();
}

GroundModel::~GroundModel() = default;

std::vector<uint64_t> GroundModel::Pack(const std::vector<bool>& state) const {
  if (state.size() != task_.atoms.size()) {
    throw std::invalid_argument("a state of " + std::to_string(state.size()) +
                                " atoms; the task has " +
                                std::to_string(task_.atoms.size()));
  }
  std::vector<uint64_t> words(static_cast<size_t>(num_words_));
  for (size_t atom = 0; atom < state.size(); ++atom) {
    if (state[atom]) words[atom / 64] |= uint64_t{1} << (atom % 64);
  }
  return words;
}

std::vector<uint64_t> GroundModel::initial() const {
  return Pack(task_.initial);
}

bool GroundModel::IsGoal(Bits state) const {
  return compiled_->packed.IsGoal(state);
}

void GroundModel::Expand(Bits state, Expansion* expansion) const {
  compiled_->packed.Expand(state, expansion);
}

std::string GroundModel::ActionName(int action) const {
  return task_.actions.at(static_cast<size_t>(action)).name;
}

Estimate GroundModel::Assess(std::span<uint64_t> state) const {
  return compiled_->relaxation.Assess(state);
}

}  // namespace cell::planning
