#include "common/actions/skill_needs.h"

#include <algorithm>
#include <optional>

#include "common/relational/literal_properties.h"

namespace cell {
namespace {

std::optional<int> FindReported(Predicate::Report report,
                                const Vocabulary& vocabulary) {
  const auto it = std::ranges::find(vocabulary.predicates(),
                                    std::optional(report), &Predicate::report);
  if (it == vocabulary.predicates().end()) return std::nullopt;
  return static_cast<int>(it - vocabulary.predicates().begin());
}

Literal Negation(Literal literal) {
  literal.is_negated = !literal.is_negated;
  return literal;
}

/// Of a skill that takes `part` and leaves it in its place.
std::vector<RobotAddition> NeedsToPlace(const Term& part, const Term& arm,
                                        const Vocabulary& vocabulary) {
  const auto held = FindReported(Predicate::Report::kHeld, vocabulary);
  const auto reachable =
      FindReported(Predicate::Report::kReachable, vocabulary);
  std::vector<RobotAddition> needs;
  RobotAddition taking;
  if (reachable) taking.context.push_back({false, *reachable, {arm, part}});
  if (held) {
    const Literal holds_it{false, *held, {part, arm}};
    const Literal holds_any{false, *held, {Term{}, arm}};
    taking.context.push_back(Negation(holds_any));
    needs.push_back({{holds_it}, {Negation(holds_it)}});
  }
  if (!taking.context.empty()) needs.push_back(taking);
  return needs;
}

bool NamesWhatArmsReport(const NdrRule& rule, const Vocabulary& vocabulary) {
  return std::ranges::any_of(rule.context, [&](const Literal& literal) {
    return IsReported(literal, vocabulary);
  });
}

}  // namespace

std::vector<RobotAddition> NeedsOf(const SkillBinding& skill,
                                   const Vocabulary& vocabulary) {
  const auto part = skill.arguments.find("part");
  if (skill.name != "insert" || part == skill.arguments.end()) return {};
  return NeedsToPlace(part->second, skill.arm, vocabulary);
}

Action WithSkillNeeds(Action action, const Vocabulary& vocabulary) {
  if (!action.skill) return action;
  const auto needs = NeedsOf(*action.skill, vocabulary);
  if (needs.empty()) return action;
  AddForRobot(
      needs,
      [&](const NdrRule& rule) {
        return !NamesWhatArmsReport(rule, vocabulary);
      },
      &action);
  return action;
}

}  // namespace cell
