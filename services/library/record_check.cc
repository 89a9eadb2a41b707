#include "services/library/record_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "common/actions/action_model_reader.h"
#include "common/task/task.h"
#include "services/library/record_json.h"

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
    : domain_(domain),
      parts_(parts),
      skill_settings_(std::move(skill_settings)) {}

RecordCheck RecordCheck::FromTask(const Deployment& deployment) {
  const Task task = LoadTask(deployment);
  std::set<std::string> sections;
  for (const auto& entry : deployment.OfTask("skills.yaml").Entries()) {
    sections.insert(entry.first);
  }
  return RecordCheck(task.domain, task.parts, std::move(sections));
}

std::optional<std::string> RecordCheck::WhyOfAnotherTask(
    const ActionStore& store) const {
  for (const ActionRecord& record : store.All()) {
    try {
      RequireSense(record, store);
    } catch (const ConfigError& e) {
      const auto change = store.ChangeOf(record.id);
      return fmt::format("action {}: {} (stored by {})", record.id, e.what(),
                         change ? "build " + change->build
                                : "a build that did not say which it was");
    }
  }
  return std::nullopt;
}

std::optional<Refusal> RecordCheck::WhyNot(const ActionRecord& record,
                                           const ActionStore& store) const {
  try {
    const size_t size = JsonOf(record).size();
    if (size > kMaxBytes) {
      return Refusal{Refusal::Kind::kTooLarge,
                     fmt::format("{} bytes are too many; at most {} are stored",
                                 size, kMaxBytes)};
    }
    if (auto refusal = NameRefusal(record, store)) return refusal;
    RequireSense(record, store);
    return std::nullopt;
  } catch (const std::invalid_argument& e) {
    return Invalid(std::string("the record ") + e.what());
  } catch (const ConfigError& e) {
    return Invalid(e.what());
  }
}

std::optional<Refusal> RecordCheck::NameRefusal(
    const ActionRecord& record, const ActionStore& store) const {
  if (record.id != 0) {
    return Invalid(fmt::format(
        "it has the id {}; the library assigns ids; send 0", record.id));
  }
  if (record.name.empty()) return Invalid("its name is empty");
  if (record.name.size() > kMaxName || !IsName(record.name)) {
    return Invalid(
        fmt::format("its name should be a letter, then letters, digits and _, "
                    "at most {} in all",
                    kMaxName));
  }
  if (record.version < 1 || record.version > ActionRecord::kMaxVersion) {
    return Invalid(fmt::format("it has the version {}; 1 to {} are allowed",
                               record.version, ActionRecord::kMaxVersion));
  }
  const auto known = store.FindNamed(record.name);
  if (known && record.version <= known->version) {
    return Refusal{
        Refusal::Kind::kDuplicate,
        fmt::format("'{}' already exists, with id {} and version {}; {} "
                    "would replace it",
                    known->name, known->id, known->version, known->version + 1),
        known->id};
  }
  const int64_t next = known ? known->version + 1 : 1;
  if (record.version != next) {
    return Invalid(fmt::format("it has the version {}; the next of '{}' is {}",
                               record.version, record.name, next));
  }
  if (known) return std::nullopt;
  if (store.Count() >= kMaxActions) {
    return Refusal{
        Refusal::Kind::kTooLarge,
        fmt::format("the library is full: it has {} actions", kMaxActions)};
  }
  return std::nullopt;
}

/// @throws ConfigError.
void RecordCheck::RequireSense(const ActionRecord& record,
                               const ActionStore& store) const {
  const auto fail = [&](const std::string& key, const std::string& what) {
    throw ConfigError(record.name + ":" + key + ": " + what);
  };
  ActionRecord alone = record;
  alone.undoes.clear();  // it may undo one that only the store knows
  ReadActionModel(alone, domain_, parts_);
  const auto known = store.FindNamed(record.name);
  if (known && TypesOf(*known) != TypesOf(record)) {
    fail("arguments",
         fmt::format("a new version must keep those of the last: {}",
                     fmt::join(TypesOf(*known), ", ")));
  }
  if (record.is_removed()) {
    for (const ActionRecord& other : store.All()) {
      if (other.undoes != record.name) continue;
      fail("agents",
           fmt::format("'{}' undoes it; remove that first", other.name));
    }
  }
  if (!record.undoes.empty()) {
    const auto undone = store.FindNamed(record.undoes);
    if (!undone || undone->is_removed())
      fail("undoes", "there is no action '" + record.undoes + "'");
    if (TypesOf(*undone) != TypesOf(record)) {
      fail("undoes", "'" + record.undoes + "' takes other arguments");
    }
  }
  if (record.skill.empty() != record.skill_settings.empty()) {
    fail("skill_settings", "is required with a skill, and only with a skill");
  }
  if (!record.skill.empty() &&
      !skill_settings_.contains(record.skill_settings)) {
    fail("skill_settings",
         "skills.yaml has no section '" + record.skill_settings + "'");
  }
}

}  // namespace cell::library
