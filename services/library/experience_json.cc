#include "services/library/experience_json.h"

#include <fmt/format.h>

#include "services/library/strict_json.h"

namespace cell::library {
namespace {

std::vector<std::string> AtomsAt(const nlohmann::json& object,
                                 const std::string& key,
                                 const std::string& where) {
  std::vector<std::string> atoms = TextsAt(object, key, where);
  for (size_t i = 0; i < atoms.size(); ++i) {
    if (ParseAtom(atoms[i])) continue;
    FailAt(fmt::format("{}.{}[{}]", where, key, i),
           "should be a predicate of objects, as On(a, b), or ?On(a, b)");
  }
  return atoms;
}

}  // namespace

nlohmann::ordered_json ToJson(const ExperienceRecord& experience) {
  return {{"id", experience.id},
          {"action", experience.action},
          {"objects", experience.objects},
          {"agent", experience.agent},
          {"before", experience.before},
          {"after", experience.after},
          {"demonstration", experience.demonstration}};
}

std::string JsonOf(const ExperienceRecord& experience) {
  return Dump(ToJson(experience), -1);
}

ExperienceRecord ExperienceFromJson(const nlohmann::json& object,
                                    const std::string& where) {
  RequireObject(
      object, where,
      {"id", "action", "objects", "agent", "before", "after", "demonstration"});
  ExperienceRecord experience;
  experience.id = NumberAt(object, "id", where, 1);
  experience.action = TextAt(object, "action", where);
  experience.objects = TextsAt(object, "objects", where);
  experience.agent = TextAt(object, "agent", where);
  experience.before = AtomsAt(object, "before", where);
  experience.after = AtomsAt(object, "after", where);
  experience.demonstration = TextAt(object, "demonstration", where);
  return experience;
}

}  // namespace cell::library
