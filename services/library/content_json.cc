#include "services/library/content_json.h"

#include <fmt/format.h>

#include "common/actions/build_version.h"
#include "services/library/experience_json.h"
#include "services/library/record_json.h"
#include "services/library/strict_json.h"

namespace cell::library {
namespace {

constexpr char kFormat[] = "actions of a cell";
// In 1 records have no version; in 1 and 2 the content does not name the build;
// from 4 on it has experiences.
constexpr int kNewestFormat = 4;

void RequireFormat(const nlohmann::json& content, const std::string& file) {
  if (!content.is_object()) FailAt(file, "should be an object");
  if (TextAt(content, "format", file) != kFormat) {
    FailAt(file + ".format", fmt::format("should be '{}'", kFormat));
  }
  const int64_t version = NumberAt(content, "version", file, 0);
  if (version >= 1 && version <= kNewestFormat) return;
  const auto build = content.find("build");
  FailAt(file + ".version",
         fmt::format("is {}; this build ({}) reads 1 to {}; use {}, or a newer "
                     "one",
                     version, BuildVersion(), kNewestFormat,
                     build != content.end() && build->is_string()
                         ? "build " + build->get<std::string>()
                         : "the build of the cell that wrote it"));
}

void ReadActions(const nlohmann::json& json, int64_t version,
                 const std::string& file, LibraryContent* content) {
  for (nlohmann::json item : ListAt(json, "actions", file)) {
    if (version == 1 && item.is_object()) item["version"] = 1;
    content->actions.push_back(RecordFromJson(
        item, fmt::format("{}:actions[{}]", file, content->actions.size())));
  }
}

void ReadExperiences(const nlohmann::json& json, const std::string& file,
                     LibraryContent* content) {
  content->last_experience = NumberAt(json, "last_experience", file, 0);
  int64_t last = 0;
  for (const nlohmann::json& item : ListAt(json, "experiences", file)) {
    const std::string where =
        fmt::format("{}:experiences[{}]", file, content->experiences.size());
    content->experiences.push_back(ExperienceFromJson(item, where));
    const int64_t id = content->experiences.back().id;
    if (id <= last || id > content->last_experience) {
      FailAt(where + ".id",
             fmt::format("is {}; ids ascend from 1 to last_experience, {}", id,
                         content->last_experience));
    }
    last = id;
  }
}

}  // namespace

std::string TextOfContent(const LibraryContent& content) {
  nlohmann::ordered_json json = {{"format", kFormat},
                                 {"version", kNewestFormat},
                                 {"build", BuildVersion()}};
  json["actions"] = nlohmann::ordered_json::array();
  for (const ActionRecord& record : content.actions) {
    json["actions"].push_back(ToJson(record));
  }
  json["last_experience"] = content.last_experience;
  json["experiences"] = nlohmann::ordered_json::array();
  for (const ExperienceRecord& experience : content.experiences) {
    json["experiences"].push_back(ToJson(experience));
  }
  return Dump(json, 1) + "\n";
}

LibraryContent ContentFromText(const std::string& text,
                               const std::string& file) {
  const nlohmann::json json = ParseJson(text, file);
  RequireFormat(json, file);
  const int64_t version = NumberAt(json, "version", file, 0);
  std::vector<std::string_view> keys = {"format", "version", "build",
                                        "actions"};
  if (version >= 4) keys.insert(keys.end(), {"last_experience", "experiences"});
  RequireObject(json, file, keys);
  if (version >= 3) TextAt(json, "build", file);
  LibraryContent content;
  ReadActions(json, version, file, &content);
  if (version >= 4) ReadExperiences(json, file, &content);
  return content;
}

}  // namespace cell::library
