#include "services/library/record_check.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "common/sec/gallery.h"
#include "services/library/record_json.h"
#include "services/library/record_language.h"

namespace cell::library {
namespace {

bool IsName(const std::string& name) {
  return std::isalpha(static_cast<unsigned char>(name[0])) &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) || c == '_';
         });
}

Refusal Invalid(const std::string& reason) {
  return {Refusal::Kind::kInvalid, reason};
}

std::vector<std::string> TypesOf(const ActionRecord& record) {
  std::vector<std::string> types;
  for (const auto& argument : record.arguments) types.push_back(argument.type);
  return types;
}

}  // namespace

RecordCheck::RecordCheck(const Domain& domain, const PartTable& parts,
                         std::set<std::string> skill_settings)
    : gallery_(std::make_shared<const Gallery>(domain, parts)),
      skill_settings_(std::move(skill_settings)) {}

RecordCheck RecordCheck::FromTask(const Deployment& deployment) {
  const PartTable parts =
      PartTable::FromConfig(deployment.OfTask("parts.yaml"));
  const Config config = deployment.OfTask("domain.yaml");
  const Domain domain = Domain::FromConfig(config, parts);
  domain.PassOverGeometry();
  domain.PassOverSec();
  config.Finish();
  std::set<std::string> sections;
  for (const auto& entry : deployment.OfTask("skills.yaml").Entries()) {
    sections.insert(entry.first);
  }
  return RecordCheck(domain, parts, std::move(sections));
}

std::optional<Refusal> RecordCheck::WhyNot(const ActionRecord& record,
                                           const ActionStore& store) const {
  try {
    const size_t size = JsonOf(record).size();
    if (size > kMaxBytes) {
      return Refusal{
          Refusal::Kind::kTooLarge,
          fmt::format("{} bytes are too many; {} are kept", size, kMaxBytes)};
    }
    if (auto refusal = NameRefusal(record, store)) return refusal;
    RequireSense(record, store);
    return std::nullopt;
  } catch (const std::invalid_argument& e) {
    return Invalid(std::string("the record ") + e.what());
  } catch (const ConfigError& e) {
    return Invalid(e.what());
  } catch (const YAML::Exception& e) {  // keys that are no names
    return Invalid(record.name + ": not the YAML of a domain: " + e.msg);
  }
}

std::optional<Refusal> RecordCheck::NameRefusal(
    const ActionRecord& record, const ActionStore& store) const {
  if (record.id != 0) {
    return Invalid(
        fmt::format("it has the id {}; the library gives ids, 0 is "
                    "sent",
                    record.id));
  }
  if (record.name.empty()) return Invalid("its name is empty");
  if (record.name.size() > kMaxName || !IsName(record.name)) {
    return Invalid(
        fmt::format("its name is not a letter, then letters, digits "
                    "and _, {} in all",
                    kMaxName));
  }
  if (const auto known = store.FindNamed(record.name)) {
    return Refusal{Refusal::Kind::kDuplicate,
                   fmt::format("'{}' is there already, with id {}", known->name,
                               known->id),
                   known->id};
  }
  if (store.Count() >= kMaxActions) {
    return Refusal{
        Refusal::Kind::kTooLarge,
        fmt::format("the library is full: it has {} actions", kMaxActions)};
  }
  return std::nullopt;
}

/// @throws ConfigError, YAML::Exception.
void RecordCheck::RequireSense(const ActionRecord& record,
                               const ActionStore& store) const {
  const auto fail = [&](const std::string& key, const std::string& what) {
    throw ConfigError(record.name + ":" + key + ": " + what);
  };
  if (record.agents.empty()) fail("agents", "nobody can do it");
  if (record.rules.empty()) fail("rules", "missing");
  const Config config = ConfigOf(record);
  const Action action =
      LoadAction(record.name, config, gallery_->domain().vocabulary());
  if (action.sec) gallery_->Read(action, 0);
  config.Finish();
  if (!record.undoes.empty()) {
    const auto undone = store.FindNamed(record.undoes);
    if (!undone) fail("undoes", "there is no action '" + record.undoes + "'");
    if (TypesOf(*undone) != TypesOf(record)) {
      fail("undoes", "'" + record.undoes + "' takes other arguments");
    }
  }
  if (record.skill.empty() != record.skill_settings.empty()) {
    fail("skill_settings", "goes with a skill, and a skill with it");
  }
  if (!record.skill.empty() &&
      !skill_settings_.contains(record.skill_settings)) {
    fail("skill_settings",
         "skills.yaml has no section '" + record.skill_settings + "'");
  }
}

}  // namespace cell::library
