#include "common/planning/all_changes.h"

namespace cell::planning {
namespace {

class AllChanges {
 public:
  AllChanges(const GroundTask& task,
             const std::function<bool(const Changes&)>& helps)
      : task_(task), helps_(helps) {}

  /// Adds `num_open` changes of atoms from `next` on; true once they help.
  bool Extend(size_t next, int num_open) {
    if (num_open == 0) {
      ++num_tried_;
      return helps_(changes_);
    }
    for (size_t atom = next; atom < task_.atoms.size(); ++atom) {
      changes_.push_back({static_cast<int>(atom), !task_.initial[atom]});
      if (Extend(atom + 1, num_open - 1)) return true;
      changes_.pop_back();
    }
    return false;
  }

  const Changes& changes() const { return changes_; }
  int64_t num_tried() const { return num_tried_; }

 private:
  const GroundTask& task_;
  const std::function<bool(const Changes&)>& helps_;
  Changes changes_;
  int64_t num_tried_ = 0;
};

}  // namespace

std::optional<Changes> FindAmongAllChanges(
    const GroundTask& task, int size,
    const std::function<bool(const Changes&)>& helps, int64_t* num_tried) {
  AllChanges all(task, helps);
  const bool is_found = all.Extend(0, size);
  if (num_tried != nullptr) *num_tried += all.num_tried();
  if (!is_found) return std::nullopt;
  return all.changes();
}

}  // namespace cell::planning
