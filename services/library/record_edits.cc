#include "services/library/record_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "common/actions/action_model_reader.h"
#include "common/sec/chain_similarities.h"
#include "common/sec/learned_model_text.h"
#include "common/sec/sec_learner.h"
#include "services/library/experience_edits.h"
#include "services/library/memory_action_store.h"

namespace cell::library {
namespace {

using Records = RecordEdits::Records;

const ActionRecord* FindIn(const Records& records, const std::string& name) {
  const auto found = std::ranges::find(records, name, &ActionRecord::name);
  return found == records.end() ? nullptr : &*found;
}

bool SaysTheSame(ActionRecord a, const ActionRecord& b) {
  a.id = b.id;
  a.version = b.version;
  return a == b;
}

ActionModel ModelOf(ActionRecord record, const Domain& domain,
                    const PartTable& parts) {
  record.undoes.clear();  // it may undo one that only the library knows
  return ReadActionModel(record, domain, parts);
}

/// The learner that has learned what the records say. @throws ConfigError.
SecLearner LearnerOf(const Records& content, const Domain& domain,
                     const PartTable& parts) {
  SecLearner learner(std::make_shared<const SceneWords>(
                         SceneWords{domain.vocabulary(), parts}),
                     MakeChainSimilarity(SecLearner::kMeasure), {});
  for (const ActionRecord& record : content) {
    if (record.sec.empty()) continue;
    const ActionModel model = ModelOf(record, domain, parts);
    if (model.sec) learner.Know(record.name, *model.sec);
  }
  return learner;
}

std::optional<LearnedModel> LearnedOf(const SecLearner& learner,
                                      const std::string& name) {
  for (SecLearner::Action& action : learner.Actions()) {
    if (action.name == name) return std::move(action.model);
  }
  return std::nullopt;
}

}  // namespace

Result<ActionRecord> RecordEdits::Find(const std::string& name) const {
  const ActionRecord* record = FindIn(content_.actions, name);
  if (record == nullptr || record->is_removed()) {
    return Reason{"there is no action '" + name + "' (cell library list)"};
  }
  return *record;
}

/// The record under this name, as the library would store it next.
ActionRecord RecordEdits::Next(ActionRecord record,
                               const std::string& name) const {
  const ActionRecord* known = FindIn(content_.actions, name);
  record.id = 0;
  record.name = name;
  record.version = known == nullptr ? 1 : known->version + 1;
  return record;
}

Result<StoreEdit> RecordEdits::Rename(const std::string& name,
                                      const std::string& new_name) const {
  const auto record = Find(name);
  if (!record) return Reason{record.reason()};
  if (Find(new_name)) {
    return Reason{fmt::format(
        "'{}' already exists; choose another name, or merge the two",
        new_name)};
  }
  StoreEdit edit;
  Records& records = edit.records;
  records = {Next(*record, new_name)};
  for (const ActionRecord& other : content_.actions) {
    if (other.undoes != name) continue;
    records.push_back(Next(other, other.name));
    records.back().undoes = new_name;
  }
  records.push_back(Removed(*record));
  MoveExperiences(content_.experiences, name, new_name, &edit);
  return edit;
}

Result<StoreEdit> RecordEdits::Remove(const std::string& name) const {
  const auto record = Find(name);
  if (!record) return Reason{record.reason()};
  return StoreEdit{.records = {Removed(*record)}};
}

Result<ActionRecord> RecordEdits::WithSec(const ActionRecord& record,
                                          const LearnedModel& model) const {
  const auto fitted =
      FitToArguments(model, ModelOf(record, domain_, parts_).action.arguments,
                     domain_.vocabulary().types());
  if (!fitted) return Reason{record.name + ": " + fitted.reason()};
  ActionRecord next = Next(record, record.name);
  next.sec = ToText(*fitted, domain_.vocabulary());
  return next;
}

Result<StoreEdit> RecordEdits::Merge(const std::string& name,
                                     const std::string& into) const {
  const auto record = Find(name);
  const auto kept = Find(into);
  if (!record || !kept) return Reason{record.reason() + kept.reason()};
  SecLearner learner = LearnerOf(content_.actions, domain_, parts_);
  if (const auto merged = learner.Merge(name, into); !merged) {
    return Reason{merged.reason()};
  }
  const auto next = WithSec(*kept, LearnedOf(learner, into).value());
  if (!next) return Reason{next.reason()};
  StoreEdit edit{.records = {*next, Removed(*record)}};
  MoveExperiences(content_.experiences, name, into, &edit);
  return edit;
}

Result<StoreEdit> RecordEdits::TakeBack(
    const std::string& demonstration) const {
  StoreEdit edit;
  ForgetExperiences(content_.experiences, demonstration, &edit);
  auto records = RecordsWithout(demonstration);
  if (!records) return Reason{records.reason()};
  edit.records = *std::move(records);
  if (edit.records.empty() && !edit.has_experiences()) {
    return Reason{"'" + demonstration + "' has taught nothing that is kept"};
  }
  return edit;
}

Result<Records> RecordEdits::RecordsWithout(
    const std::string& demonstration) const {
  SecLearner learner = LearnerOf(content_.actions, domain_, parts_);
  const auto names = learner.TakeBack(demonstration);
  if (!names) return Reason{names.reason()};
  Records records;
  for (const std::string& name : *names) {
    const ActionRecord& record = *FindIn(content_.actions, name);
    if (const auto model = LearnedOf(learner, name)) {
      const auto next = WithSec(record, *model);
      if (!next) return Reason{next.reason()};
      records.push_back(*next);
    } else if (SecLearner::IsMadeUp(name)) {
      records.push_back(Removed(record));
    } else {
      records.push_back(Next(record, name));
      records.back().sec.clear();
    }
  }
  return records;
}

Result<StoreEdit> RecordEdits::Restore(const LibraryContent& earlier) const {
  StoreEdit edit{.records = RecordsOf(earlier.actions)};
  RestoreExperiences(content_.experiences, earlier.experiences, &edit);
  if (edit.records.empty() && !edit.has_experiences()) {
    return Reason{"the library already holds that"};
  }
  return edit;
}

/// That make the actions what they were.
Records RecordEdits::RecordsOf(const Records& earlier) const {
  Records records;
  for (const ActionRecord& record : earlier) {
    const ActionRecord* known = FindIn(content_.actions, record.name);
    if (known != nullptr && SaysTheSame(record, *known)) continue;
    records.push_back(Next(record, record.name));
  }
  for (const ActionRecord& record : content_.actions) {
    if (record.is_removed() || FindIn(earlier, record.name)) continue;
    records.push_back(Removed(record));
  }
  // An action that undoes another one can be stored only after it, and removed
  // only before it.
  std::ranges::stable_sort(records, {}, [](const ActionRecord& record) {
    return std::pair(record.is_removed(), !record.undoes.empty());
  });
  return records;
}

std::string WhyNotAll(const Records& records, const RecordCheck& check,
                      const ActionStore& store) {
  MemoryActionStore known(store.All());
  for (const ActionRecord& record : records) {
    if (const auto refusal = check.WhyNot(record, known)) {
      return record.name + ": " + refusal->reason;
    }
    known.Store({&record, 1}, kBeforeRun);
  }
  return "";
}

}  // namespace cell::library
