#include "services/cell/explaining/rule_reasons.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/relational/rule_text.h"
#include "common/text/counted.h"

namespace cell::cli {
namespace {

using planner::Problem;

constexpr char kUnknownEffect[] = "nothing is known of what it does";

size_t SizeOf(const RuleGap& gap) {
  return gap.literals.size() + (gap.reference ? 1 : 0);
}

void AddRule(const Problem& problem, const GroundAction& action,
             const RuleGap& gap, Reasons* lines) {
  const Action& lifted = problem.rules->ActionOf(action);
  const NdrRule& rule = lifted.rules.at(static_cast<size_t>(gap.rule));
  for (const std::string& line :
       RuleLines(lifted, rule, gap.binding, problem.rules->vocabulary())) {
    lines->push_back("  " + line);
  }
}

void AddGap(const RuleSet& rules, const GroundAction& action,
            const RuleGap& gap, Reasons* lines) {
  lines->push_back(fmt::format("  of which it lacks: {}",
                               fmt::join(ShowGap(rules, action, gap), ", ")));
}

/// "version 3, learned from 2 experiences".
std::string OriginOf(const RuleSet& rules, const GroundAction& action,
                     const RuleGap& gap) {
  const NdrRule& rule =
      rules.ActionOf(action).rules.at(static_cast<size_t>(gap.rule));
  std::string text = fmt::format("version {}", rules.version());
  if (rule.num_experiences > 0) {
    text += ", learned from " + Counted(rule.num_experiences, "experience");
  }
  return text;
}

/// True if the change would make a literal of the context hold that does not.
bool IsFilledBy(const RuleGap& gap, const planner::RequiredChange& change,
                const Vocabulary& vocabulary) {
  return std::ranges::any_of(gap.literals, [&](const Literal& literal) {
    const auto atoms = Groundings(literal, gap.binding, vocabulary);
    return literal.is_negated == (change.truth == Truth::kFalse) &&
           std::ranges::count(atoms, change.atom) > 0;
  });
}

}  // namespace

Reasons CoveringRules(const Problem& problem, const GroundAction& action,
                      const State& state) {
  Reasons lines;
  for (const RuleGap& gap :
       GapsOf(*problem.rules, action, state, problem.agent)) {
    if (!gap.is_covered()) continue;
    lines.push_back(fmt::format(
        "{} ({}):",
        lines.empty() ? "by this rule" : "or, as something is unknown, by this",
        OriginOf(*problem.rules, action, gap)));
    AddRule(problem, action, gap, &lines);
  }
  return lines;
}

Reasons RuleThatNeeds(const Problem& problem, const GroundAction& action,
                      const State& state,
                      const planner::RequiredChange& change) {
  const RuleSet& rules = *problem.rules;
  std::optional<RuleGap> nearest;
  for (const RuleGap& gap : GapsOf(rules, action, state, problem.agent)) {
    if (!IsFilledBy(gap, change, rules.vocabulary())) continue;
    if (!nearest || SizeOf(gap) < SizeOf(*nearest)) nearest = gap;
  }
  if (!nearest) return {};
  Reasons lines = {fmt::format(
      "{} has this precondition in this rule ({}):", rules.Show(action),
      OriginOf(rules, action, *nearest))};
  AddRule(problem, action, *nearest, &lines);
  AddGap(rules, action, *nearest, &lines);
  return lines;
}

Reasons NearestRule(const Problem& problem, const GroundAction& action,
                    const State& state) {
  const RuleSet& rules = *problem.rules;
  const auto gaps = GapsOf(rules, action, state, problem.agent);
  const auto nearest = std::ranges::min_element(gaps, {}, SizeOf);
  if (nearest == gaps.end()) return {};
  Reasons lines = {
      fmt::format("its rule ({}):", OriginOf(rules, action, *nearest))};
  AddRule(problem, action, *nearest, &lines);
  AddGap(rules, action, *nearest, &lines);
  return lines;
}

std::string WhyNotPossible(const Problem& problem, const GroundAction& action,
                           const State& state) {
  const RuleSet& rules = *problem.rules;
  const auto gaps = GapsOf(rules, action, state, problem.agent);
  const auto num_covering = std::ranges::count_if(gaps, &RuleGap::is_covered);
  if (num_covering > 1) {
    return fmt::format("{} rules cover it at once, so that {}", num_covering,
                       kUnknownEffect);
  }
  if (num_covering == 1) return "would change nothing";
  const auto nearest = std::ranges::min_element(gaps, {}, SizeOf);
  if (nearest == gaps.end())
    return fmt::format("has no rule: {}", kUnknownEffect);
  return fmt::format("needs {}",
                     fmt::join(ShowGap(rules, action, *nearest), ", "));
}

}  // namespace cell::cli
