#include "common/relational/rule_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "common/relational/domain.h"
#include "common/relational/ground_action.h"

namespace cell {
namespace {

using Texts = std::vector<std::string>;

std::string ShowTypes(const std::string& name, const std::vector<int>& types,
                      const Vocabulary& vocabulary) {
  Texts names;
  for (const int type : types) names.push_back(vocabulary.types().name(type));
  return fmt::format("{}({})", name, fmt::join(names, ", "));
}

Texts TypesOf(const Vocabulary& vocabulary) {
  const TypeHierarchy& types = vocabulary.types();
  Texts texts;
  for (int type = 0; type < types.size(); ++type) {
    Texts ancestors;
    for (int other = 0; other < types.size(); ++other) {
      if (types.IsA(type, other)) ancestors.push_back(types.name(other));
    }
    texts.push_back(
        fmt::format("{} ({})", types.name(type), fmt::join(ancestors, ", ")));
  }
  return texts;
}

Texts ObjectsOf(const Vocabulary& vocabulary) {
  Texts texts;
  for (const Object& object : vocabulary.objects()) {
    texts.push_back(object.name + ": " + vocabulary.types().name(object.type));
  }
  return texts;
}

Texts PredicatesOf(const Vocabulary& vocabulary) {
  Texts texts;
  for (const Predicate& predicate : vocabulary.predicates()) {
    texts.push_back(
        ShowTypes(predicate.name, predicate.argument_types, vocabulary));
    if (predicate.report == Predicate::Report::kHeld) {
      texts.back() += ", reported: held";
    } else if (predicate.report) {
      texts.back() += ", reported: reachable";
    }
  }
  return texts;
}

Texts StaticFactsOf(const Vocabulary& vocabulary) {
  Texts texts;
  for (const StaticRelation& relation : vocabulary.static_relations()) {
    texts.push_back(
        ShowTypes(relation.name, relation.argument_types, vocabulary));
    for (const std::vector<int>& fact : relation.facts) {
      texts.push_back(vocabulary.Show(relation.name, fact));
    }
  }
  return texts;
}

/// "key[2]: is 'Near(part)'; must be 'Far(part)' ..." at the first difference.
std::optional<std::string> Difference(const std::string& key, const Texts& here,
                                      const Texts& there) {
  const auto text_at = [](const Texts& texts, size_t i) {
    return i < texts.size() ? "'" + texts[i] + "'" : std::string("nothing");
  };
  for (size_t i = 0; i < std::max(here.size(), there.size()); ++i) {
    if (text_at(here, i) == text_at(there, i)) continue;
    return fmt::format("{}[{}]: is {}; must be {}, as in the task's domain",
                       key, i, text_at(here, i), text_at(there, i));
  }
  return std::nullopt;
}

std::optional<std::string> Difference(const Vocabulary& here,
                                      const Vocabulary& there) {
  auto difference = Difference("types", TypesOf(here), TypesOf(there));
  const auto compare = [&](const std::string& key,
                           Texts (*list)(const Vocabulary&)) {
    if (!difference) difference = Difference(key, list(here), list(there));
  };
  compare("objects", ObjectsOf);
  compare("predicates", PredicatesOf);
  compare("static_facts", StaticFactsOf);
  return difference;
}

std::string Signature(const Action& action, const Vocabulary& vocabulary) {
  std::vector<int> types;
  for (const Variable& v : action.arguments) types.push_back(v.type);
  return ShowTypes(action.name, types, vocabulary);
}

}  // namespace

RuleSet::RuleSet(std::string source, int64_t version,
                 std::shared_ptr<const Vocabulary> vocabulary,
                 std::vector<Action> actions)
    : source_(std::move(source)),
      version_(version),
      vocabulary_(std::move(vocabulary)),
      actions_(std::move(actions)) {}

std::shared_ptr<const RuleSet> RuleSet::FromDomain(const Domain& domain,
                                                   const std::string& source,
                                                   int64_t version) {
  return std::make_shared<RuleSet>(
      source, version, std::make_shared<Vocabulary>(domain.vocabulary()),
      domain.actions());
}

std::vector<GroundAction> RuleSet::GroundActions(Agent agent) const {
  return cell::GroundActions(actions_, *vocabulary_, agent);
}

std::optional<GroundAction> RuleSet::FindGroundAction(
    const std::string& name, const std::vector<std::string>& objects) const {
  return cell::FindGroundAction(actions_, *vocabulary_, name, objects);
}

std::optional<GroundSkill> RuleSet::SkillOf(const GroundAction& action) const {
  const std::optional<SkillBinding>& skill = ActionOf(action).skill;
  if (!skill) return std::nullopt;
  return Bind(*skill, action.arguments);
}

std::string RuleSet::Show(const GroundAction& action) const {
  return vocabulary_->Show(ActionOf(action).name, action.arguments);
}

std::optional<std::string> RuleSet::WhyNotReplace(
    const RuleSet& current) const {
  if (version_ <= current.version_) {
    return fmt::format("{}:version: is {}; must be more than {}, which is used",
                       source_, version_, current.version_);
  }
  if (vocabulary_ != current.vocabulary_) {
    const auto difference = Difference(*vocabulary_, *current.vocabulary_);
    if (difference) return source_ + ":" + *difference;
  }
  for (size_t i = 0; i < current.actions_.size(); ++i) {
    const auto wanted = Signature(current.actions_[i], *current.vocabulary_);
    const std::string found =
        i < actions_.size() ? Signature(actions_[i], *vocabulary_) : "nothing";
    if (found == wanted) continue;
    return fmt::format(
        "{}:actions[{}]: is {}; must be {}: the actions of the rule set in use "
        "keep their places, and new ones follow",
        source_, i, found, wanted);
  }
  return std::nullopt;
}

}  // namespace cell
