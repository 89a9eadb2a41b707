#include "services/library/experience_check.h"

#include <fmt/format.h>

#include "common/experiences/task_experience.h"
#include "common/text/nearest.h"

namespace cell::library {
namespace {

Refusal InvalidExperience(const std::string& reason) {
  return {Refusal::Kind::kInvalid, reason};
}

}  // namespace

std::optional<Refusal> ExperienceCheck::WhyNot(const experience_t& message,
                                               const ActionStore& store) const {
  const auto size = static_cast<size_t>(message.getEncodedSize());
  if (size > ExperienceRecord::kMaxBytes) {
    return Refusal{Refusal::Kind::kTooLarge,
                   fmt::format("{} bytes are too many; at most {} are stored",
                               size, ExperienceRecord::kMaxBytes)};
  }
  if (message.id != 0) {
    return InvalidExperience(fmt::format(
        "it has the id {}; the library assigns ids; send 0", message.id));
  }
  if (const auto read = FromMessage(message, vocabulary_); !read) {
    return InvalidExperience(read.reason());
  }
  const auto action = store.FindNamed(message.action);
  if (action && action->arguments.size() != message.arguments.size()) {
    return InvalidExperience(
        fmt::format("arguments: {} takes {} objects, not {}", message.action,
                    action->arguments.size(), message.arguments.size()));
  }
  if (store.NumExperiences() >= kMaxExperiences) {
    return Refusal{Refusal::Kind::kTooLarge,
                   fmt::format("the library is full: it has {} experiences; "
                               "go on with another one (--library)",
                               kMaxExperiences)};
  }
  return std::nullopt;
}

bool ExperienceCheck::IsOfTask(const ExperienceRecord& experience) const {
  return bool{FromMessage(ToMessage(experience), vocabulary_)};
}

std::optional<std::string> ExperienceCheck::WhyOfAnotherTask(
    const ActionStore& store) const {
  for (const ExperienceRecord& experience : store.Experiences()) {
    for (const auto* atoms : {&experience.before, &experience.after}) {
      for (const std::string& text : *atoms) {
        const auto atom = ParseAtom(text);
        const auto predicate = vocabulary_.FindPredicate(atom->predicate);
        if (!predicate) {
          return fmt::format(
              "experience {}: the task has no predicate '{}'{}", experience.id,
              atom->predicate,
              NamesInstead(atom->predicate, NamesIn(vocabulary_.predicates(),
                                                    &Predicate::name)));
        }
        const size_t num_objects =
            vocabulary_.predicates()[static_cast<size_t>(*predicate)]
                .argument_types.size();
        if (num_objects != atom->arguments.size()) {
          return fmt::format("experience {}: {} takes {} objects, not {}",
                             experience.id, atom->predicate, num_objects,
                             atom->arguments.size());
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace cell::library
