#include "services/cell/learning/rule_comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace cell::cli {
namespace {

const Outcome* LikeliestOutcome(const NdrRule& rule) {
  const auto it =
      std::ranges::max_element(rule.outcomes, {}, &Outcome::probability);
  return it == rule.outcomes.end() ? nullptr : &*it;
}

/// What one set of rules says of an action in a state.
class Verdict {
 public:
  Verdict(const RuleSet& rules, const GroundAction& ground, const State& state,
          Agent agent)
      : rules_(rules), ground_(ground), state_(state), agent_(agent) {
    for (ApplicableRule& rule : ApplicableRules(
             action(), ground.arguments, state, rules.vocabulary(), agent)) {
      if (const Outcome* outcome =
              LikeliestOutcome(action().rules[rule.rule])) {
        successes_.push_back(
            Apply(*outcome, rule.binding, state, rules.vocabulary()));
      }
    }
  }

  bool is_possible() const {
    return successes_.size() == 1 && successes_.front() != state_;
  }
  const State& success() const { return successes_.front(); }

  /// Why it is not possible: all that is missing.
  std::vector<std::string> WhyNot() const {
    if (successes_.size() > 1) return {"has several rules that apply"};
    if (successes_.size() == 1) return {"changes nothing"};
    std::optional<std::vector<std::string>> fewest;
    for (const NdrRule& rule : action().rules) {
      if (!rule.IsFor(agent_)) continue;
      std::vector<std::string> missing = MissingOf(rule);
      if (!fewest || missing.size() < fewest->size()) fewest = missing;
    }
    if (!fewest) return {"has no rule"};
    if (fewest->empty()) return {"has a reference that is not unique"};
    return *fewest;
  }

 private:
  const Action& action() const { return rules_.ActionOf(ground_); }

  /// The literals of the context, without references, that do not hold.
  std::vector<std::string> MissingOf(const NdrRule& rule) const {
    const Vocabulary& vocabulary = rules_.vocabulary();
    const auto is_of_arguments = [&](const Term& term) {
      return term.kind != Term::Kind::kVariable ||
             term.index < static_cast<int>(ground_.arguments.size());
    };
    std::vector<std::string> missing;
    for (const Literal& literal : rule.context) {
      if (std::ranges::all_of(literal.terms, is_of_arguments) &&
          !MayHold(literal, ground_.arguments, state_, vocabulary)) {
        missing.push_back("needs " +
                          ToText(literal, vocabulary, action().arguments));
      }
    }
    return missing;
  }

  const RuleSet& rules_;
  const GroundAction& ground_;
  const State& state_;
  Agent agent_;
  std::vector<State> successes_;
};

/// "not Clear(bolt)": arguments by their variables, other objects by their
/// type.
std::string Generalized(int atom, bool is_true, const GroundAction& action,
                        const RuleSet& rules) {
  const Vocabulary& vocabulary = rules.vocabulary();
  const GroundAtom ground = vocabulary.Atom(atom);
  std::vector<std::string> names;
  for (const int object : ground.objects) {
    const auto argument = std::ranges::find(action.arguments, object);
    names.push_back(
        argument == action.arguments.end()
            ? vocabulary.types().name(vocabulary.objects()[object].type)
            : rules.ActionOf(action)
                  .arguments[argument - action.arguments.begin()]
                  .name);
  }
  return fmt::format("{}{}({})", is_true ? "" : "not ",
                     vocabulary.predicates()[ground.predicate].name,
                     fmt::join(names, ", "));
}

/// Each kind of difference once, however many objects it is of.
std::set<std::string> DifferencesOf(const State& reference,
                                    const State& learned, const State& before,
                                    const GroundAction& action,
                                    const RuleSet& rules) {
  std::set<std::string> texts;
  for (int atom = 0; atom < reference.num_atoms(); ++atom) {
    if (reference.Get(atom) == learned.Get(atom)) continue;
    const bool is_lacking = reference.Get(atom) != before.Get(atom);
    const bool is_true =
        (is_lacking ? reference : learned).Get(atom) == Truth::kTrue;
    texts.insert(fmt::format("success {} {}",
                             is_lacking ? "lacks" : "should not give",
                             Generalized(atom, is_true, action, rules)));
  }
  return texts;
}

}  // namespace

std::vector<State> StatesFrom(std::span<const State> starts,
                              const RuleSet& rules, Agent agent,
                              size_t max_states) {
  std::vector<State> states;
  std::map<uint64_t, std::vector<size_t>> places;  // by hash
  const auto add = [&](const State& state) {
    std::vector<size_t>& same = places[state.Hash()];
    const bool is_known = std::ranges::any_of(
        same, [&](size_t place) { return states[place] == state; });
    if (is_known || states.size() >= max_states) return;
    same.push_back(states.size());
    states.push_back(state);
  };
  for (const State& start : starts) add(start);
  const std::vector<GroundAction> actions = rules.GroundActions(agent);
  for (size_t i = 0; i < states.size(); ++i) {
    for (const GroundAction& action : actions) {
      const State state = states[i];
      const Action& lifted = rules.ActionOf(action);
      const auto applicable = ApplicableRules(lifted, action.arguments, state,
                                              rules.vocabulary(), agent);
      if (applicable.size() != 1) continue;
      for (const Outcome& outcome : lifted.rules[applicable[0].rule].outcomes) {
        add(Apply(outcome, applicable[0].binding, state, rules.vocabulary()));
      }
    }
  }
  return states;
}

RuleComparison::RuleComparison(std::shared_ptr<const RuleSet> reference,
                               std::shared_ptr<const RuleSet> learned,
                               Agent agent)
    : reference_(std::move(reference)),
      learned_(std::move(learned)),
      agent_(agent) {
  // Those that one of them knows nothing of must be there, too.
  ground_actions_ = reference_->GroundActions(agent_);
  for (const GroundAction& action : learned_->GroundActions(agent_)) {
    if (std::ranges::count(ground_actions_, action) == 0) {
      ground_actions_.push_back(action);
    }
  }
  std::ranges::sort(ground_actions_);
}

void RuleComparison::Add(const State& state) {
  for (const GroundAction& action : ground_actions_) Add(action, state);
}

void RuleComparison::Add(const GroundAction& action, const State& state) {
  const Verdict reference(*reference_, action, state, agent_);
  const Verdict learned(*learned_, action, state, agent_);
  ActionComparison& of_action = actions_[reference_->ActionOf(action).name];
  if (reference.is_possible() && learned.is_possible()) {
    ++of_action.num_both;
    const auto differences = DifferencesOf(
        reference.success(), learned.success(), state, action, *reference_);
    of_action.num_same += differences.empty();
    for (const std::string& text : differences) ++of_action.differences[text];
  } else if (reference.is_possible()) {
    ++of_action.num_reference_only;
    for (const std::string& why : learned.WhyNot()) {
      ++of_action.differences["learned: " + why];
    }
  } else if (learned.is_possible()) {
    ++of_action.num_learned_only;
    for (const std::string& why : reference.WhyNot()) {
      ++of_action.differences["reference: " + why];
    }
  }
}

}  // namespace cell::cli
