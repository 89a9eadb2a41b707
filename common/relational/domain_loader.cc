#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "common/relational/domain.h"
#include "common/relational/robot_addition.h"

namespace cell {
namespace {

constexpr double kSumTolerance = 1e-9;

/// A map from variables to their types.
std::vector<Variable> LoadVariables(const Config& config,
                                    const Vocabulary& vocabulary) {
  std::vector<Variable> variables;
  for (const auto& [name, node] : config.Entries()) {
    if (!std::isupper(static_cast<unsigned char>(name[0]))) {
      node.Fail("a variable begins with a capital letter");
    }
    const std::optional<int> type =
        vocabulary.types().Find(node.As<std::string>());
    if (!type) {
      node.Fail("there is no type '" + node.As<std::string>() + "'");
    }
    variables.push_back({name, *type});
  }
  return variables;
}

/// Appends `added` to `variables`; their names must be new.
void Extend(std::vector<Variable>& variables,
            const std::vector<Variable>& added, const Config& config) {
  for (const Variable& variable : added) {
    for (const Variable& known : variables) {
      if (known.name == variable.name) {
        config.Fail("the variable '" + variable.name + "' already exists");
      }
    }
    variables.push_back(variable);
  }
}

/// Literals that an action can make true: of predicates, without `_`.
std::vector<Literal> LoadChanges(const std::vector<Config>& items,
                                 const Vocabulary& vocabulary,
                                 const std::vector<Variable>& variables) {
  std::vector<Literal> changes;
  for (const Config& item : items) {
    const Literal literal = ParseLiteral(item, vocabulary, variables);
    if (literal.is_static) item.Fail("an action cannot change a static fact");
    for (const Term& term : literal.terms) {
      if (term.kind == Term::Kind::kAny) {
        item.Fail("an effect must name its objects; `_` is not allowed");
      }
    }
    Literal opposite = literal;
    opposite.is_negated = !literal.is_negated;
    if (std::count(changes.begin(), changes.end(), opposite) > 0) {
      item.Fail("contradicts another effect of the same outcome");
    }
    changes.push_back(literal);
  }
  return changes;
}

Effect LoadConditional(const Config& config, const Vocabulary& vocabulary,
                       std::vector<Variable> variables) {
  Effect effect;
  effect.each = LoadVariables(config["each"], vocabulary);
  Extend(variables, effect.each, config["each"]);
  effect.where = ParseLiterals(config["where"], vocabulary, variables);
  effect.then = LoadChanges(config["then"].Items(), vocabulary, variables);
  return effect;
}

Outcome LoadOutcome(const Config& config, const Vocabulary& vocabulary,
                    const std::vector<Variable>& variables) {
  Outcome outcome;
  outcome.probability = config.Number("probability", 0, 1);
  std::vector<Config> plain;
  for (const Config& item : config["effects"].Items()) {
    if (item.Has("each")) {
      outcome.effects.push_back(LoadConditional(item, vocabulary, variables));
    } else {
      plain.push_back(item);
    }
  }
  Effect effect;
  effect.then = LoadChanges(plain, vocabulary, variables);
  outcome.effects.push_back(std::move(effect));
  return outcome;
}

std::vector<DeicticReference> LoadReferences(const Config& config,
                                             const Vocabulary& vocabulary,
                                             std::vector<Variable>& variables) {
  std::vector<DeicticReference> references;
  for (const auto& [name, node] : config.Entries()) {
    const std::optional<int> type =
        vocabulary.types().Find(node.Get<std::string>("type"));
    if (!type) node["type"].Fail("there is no such type");
    const Variable variable{name, *type};
    Extend(variables, {variable}, node);
    references.push_back(
        {variable, ParseLiterals(node["such_that"], vocabulary, variables)});
  }
  return references;
}

std::vector<Agent> LoadAgents(const Config& action,
                              std::vector<Agent> fallback) {
  if (!action.Has("agents")) return fallback;
  std::vector<Agent> agents;
  for (const Config& item : action["agents"].Items()) {
    const auto name = item.As<std::string>();
    if (name != "person" && name != "robot") {
      item.Fail("'" + name + "' is neither person nor robot");
    }
    const Agent agent = name == "person" ? Agent::kPerson : Agent::kRobot;
    if (std::count(agents.begin(), agents.end(), agent) > 0) {
      item.Fail("'" + name + "' is named twice");
    }
    agents.push_back(agent);
  }
  if (agents.empty()) {
    action["agents"].Fail("names no agent; name person, robot, or both");
  }
  return agents;
}

/// A rule for some of the action's agents, or all of them.
std::vector<Agent> LoadAgentsOfRule(const Config& rule, const Action& action) {
  const std::vector<Agent> agents = LoadAgents(rule, action.agents);
  for (const Agent agent : agents) {
    if (!action.MayBeDoneBy(agent)) {
      rule["agents"].Fail("not all of them are agents of the action");
    }
  }
  return agents;
}

NdrRule LoadRule(const Config& config, const Vocabulary& vocabulary,
                 std::vector<Variable> variables) {
  NdrRule rule;
  if (config.Has("references")) {
    rule.references =
        LoadReferences(config["references"], vocabulary, variables);
  }
  rule.context = ParseLiterals(config["context"], vocabulary, variables);
  rule.noise = config.Number("noise", 0, 1);
  double sum = rule.noise;
  for (const Config& item : config["outcomes"].Items()) {
    rule.outcomes.push_back(LoadOutcome(item, vocabulary, variables));
    sum += rule.outcomes.back().probability;
  }
  if (std::abs(sum - 1) > kSumTolerance) {
    config.Fail(fmt::format(
        "outcomes and noise have the probability {}; it must be 1", sum));
  }
  return rule;
}

std::vector<RobotAddition> LoadAdditions(
    const Config& action, const Vocabulary& vocabulary,
    const std::vector<Variable>& arguments) {
  std::vector<RobotAddition> additions;
  for (const Config& item : action["robot"].Items()) {
    RobotAddition addition;
    addition.context = ParseLiterals(item["context"], vocabulary, arguments);
    addition.effects =
        LoadChanges(item["effects"].Items(), vocabulary, arguments);
    additions.push_back(std::move(addition));
  }
  if (additions.empty()) action["robot"].Fail("has no rule for the robot");
  return additions;
}

/// The rules themselves for the person; for the robot each of them with each
/// addition. @throws ConfigError if what a rule does is undone by what is
/// added.
void AddRobotRules(const Config& config, const Vocabulary& vocabulary,
                   Action& action) {
  if (!action.MayBeDoneBy(Agent::kRobot)) {
    config["robot"].Fail("the robot is not one of the action's agents");
  }
  const std::vector<RobotAddition> additions =
      LoadAdditions(config, vocabulary, action.arguments);
  for (const NdrRule& rule : action.rules) {
    for (const RobotAddition& addition : additions) {
      if (rule.IsFor(Agent::kRobot) && Contradicts(rule, addition)) {
        config["robot"].Fail("an effect contradicts one of the rules'");
      }
    }
  }
  AddForRobot(
      additions, [](const NdrRule&) { return true; }, &action);
}

/// The action that `config` names; its arguments must be those of `undoing`.
int FindUndone(const Config& config, const Action& undoing,
               const std::vector<Action>& actions) {
  const auto name = config.As<std::string>();
  for (size_t i = 0; i < actions.size(); ++i) {
    if (actions[i].name != name) continue;
    const bool are_equal = std::equal(
        actions[i].arguments.begin(), actions[i].arguments.end(),
        undoing.arguments.begin(), undoing.arguments.end(),
        [](const Variable& a, const Variable& b) { return a.type == b.type; });
    if (!are_equal) config.Fail("'" + name + "' takes other arguments");
    return static_cast<int>(i);
  }
  config.Fail("there is no action '" + name + "'");
}

}  // namespace

Action LoadAction(const std::string& name, const Config& config,
                  const Vocabulary& vocabulary) {
  Action action;
  action.name = name;
  Extend(action.arguments, LoadVariables(config["arguments"], vocabulary),
         config["arguments"]);
  action.agents = LoadAgents(config, {Agent::kPerson, Agent::kRobot});
  for (const Config& item : config.ItemsOf("rules")) {
    action.rules.push_back(LoadRule(item, vocabulary, action.arguments));
    action.rules.back().agents = LoadAgentsOfRule(item, action);
  }
  if (config.Has("robot")) AddRobotRules(config, vocabulary, action);
  if (config.Has("skill")) {
    action.skill =
        SkillBinding::FromConfig(config["skill"], vocabulary, action.arguments);
    if (!action.MayBeDoneBy(Agent::kRobot)) {
      config["skill"].Fail("the robot is not one of the action's agents");
    }
  }
  return action;
}

Domain Domain::FromConfig(const Config& config, const PartTable& parts) {
  Domain domain;
  domain.vocabulary_ = Vocabulary::FromConfig(config, parts);
  const auto actions = config["actions"].Entries();
  for (const auto& [name, node] : actions) {
    if (domain.FindAction(name)) node.Fail("two actions have this name");
    domain.actions_.push_back(LoadAction(name, node, domain.vocabulary_));
  }
  for (size_t i = 0; i < actions.size(); ++i) {
    const Config& node = actions[i].second;
    if (!node.Has("undoes")) continue;
    Action& action = domain.actions_[i];
    if (node["undoes"].As<std::string>() == action.name) {
      node["undoes"].Fail("an action cannot undo itself");
    }
    action.undoes = FindUndone(node["undoes"], action, domain.actions_);
  }
  domain.requests_ =
      RequestWords::FromConfig(config, domain.vocabulary_, domain.actions_);
  for (const auto& [name, node] : config["goals"].Entries()) {
    Goal goal{name, ParseLiterals(node, domain.vocabulary_, {})};
    if (goal.literals.empty()) node.Fail("has no literals");
    for (const Literal& literal : goal.literals) {
      if (literal.is_static) node.Fail("a static fact cannot be a goal");
    }
    domain.goals_.push_back(std::move(goal));
  }
  return domain;
}

}  // namespace cell
