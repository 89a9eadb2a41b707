#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cell/experience_t.hpp"
#include "common/experiences/experience_record.h"
#include "common/relational/vocabulary.h"
#include "services/library/action_store.h"
#include "services/library/record_check.h"

namespace cell::library {

/// Decides whether an experience can be kept: it must be in the words of the
/// task. Its action may be one that the library does not know (yet), and it may
/// contradict others.
class ExperienceCheck {
 public:
  /// About 15 MB of messages; the library refuses more.
  static constexpr int64_t kMaxExperiences = 2000;

  explicit ExperienceCheck(Vocabulary vocabulary)
      : vocabulary_(std::move(vocabulary)) {}

  /// Nothing: `store` may keep it.
  std::optional<Refusal> WhyNot(const experience_t& message,
                                const ActionStore& store) const;
  /// True if all its objects and atoms are of the task: an experience may be of
  /// a variant of the task that has other parts.
  bool IsOfTask(const ExperienceRecord& experience) const;
  /// An experience of the store has a predicate that the task does not have, or
  /// has for another number of objects; nothing: none has.
  std::optional<std::string> WhyOfAnotherTask(const ActionStore& store) const;

 private:
  Vocabulary vocabulary_;
};

}  // namespace cell::library
