#include "services/library/experience_edits.h"

#include <map>
#include <utility>

#include "services/library/experience_json.h"

namespace cell::library {
namespace {

constexpr char kPersonAgent[] = "person";

/// Equal for experiences that say the same.
std::string KeyOf(ExperienceRecord experience) {
  experience.id = 0;
  return JsonOf(experience);
}

}  // namespace

void MoveExperiences(const Experiences& experiences, const std::string& action,
                     const std::string& to, StoreEdit* edit) {
  for (const ExperienceRecord& experience : experiences) {
    if (experience.action != action) continue;
    edit->removed_experiences.push_back(experience.id);
    edit->experiences.push_back(experience);
    edit->experiences.back().action = to;
  }
}

void ForgetExperiences(const Experiences& experiences,
                       const std::string& demonstration, StoreEdit* edit) {
  for (const ExperienceRecord& experience : experiences) {
    if (experience.demonstration == demonstration &&
        experience.agent == kPersonAgent) {
      edit->removed_experiences.push_back(experience.id);
    }
  }
}

void RestoreExperiences(const Experiences& experiences,
                        const Experiences& earlier, StoreEdit* edit) {
  for (const auto& later : ExperiencesMissingIn(earlier, experiences)) {
    edit->removed_experiences.push_back(later.id);
  }
  edit->experiences = ExperiencesMissingIn(experiences, earlier);
}

Experiences ExperiencesMissingIn(const Experiences& others,
                                 const Experiences& experiences) {
  std::map<std::string, int> num_others;
  for (const ExperienceRecord& other : others) ++num_others[KeyOf(other)];
  Experiences missing;
  for (const ExperienceRecord& experience : experiences) {
    if (--num_others[KeyOf(experience)] < 0) missing.push_back(experience);
  }
  return missing;
}

}  // namespace cell::library
