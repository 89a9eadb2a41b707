#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "common/config/deployment.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"
#include "services/library/action_store.h"

namespace cell::library {

/// Why a record is not kept.
struct Refusal {
  enum class Kind { kDuplicate, kInvalid, kTooLarge };
  Kind kind = Kind::kInvalid;
  std::string reason;    ///< in plain words
  int64_t known_id = 0;  ///< kDuplicate: of the action that has the name
};

/// Decides whether a record can be kept: all that recognizer, planner and arms
/// will read of it must make sense in the words of the task.
class RecordCheck {
 public:
  static constexpr size_t kMaxBytes = ActionRecord::kMaxBytes;
  static constexpr size_t kMaxName = 64;  ///< [characters]
  static constexpr int64_t kMaxActions = 1000;

  /// @param skill_settings  sections of the task's skills.yaml
  RecordCheck(const Domain& domain, const PartTable& parts,
              std::set<std::string> skill_settings);
  /// @throws ConfigError.
  static RecordCheck FromTask(const Deployment& deployment);

  const Domain& domain() const { return domain_; }
  const PartTable& parts() const { return parts_; }

  /// Nothing: `store` may keep it.
  std::optional<Refusal> WhyNot(const ActionRecord& record,
                                const ActionStore& store) const;
  /// What the store keeps is not of this task; nothing: it is.
  std::optional<std::string> WhyOfAnotherTask(const ActionStore& store) const;

 private:
  std::optional<Refusal> NameRefusal(const ActionRecord& record,
                                     const ActionStore& store) const;
  void RequireSense(const ActionRecord& record, const ActionStore& store) const;

  Domain domain_;
  PartTable parts_;
  std::set<std::string> skill_settings_;
};

}  // namespace cell::library
