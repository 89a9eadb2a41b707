#include "common/relational/rule_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cell {
namespace {

using Variables = std::vector<Variable>;

std::string ListText(const std::vector<Literal>& literals,
                     const Variables& variables, const Vocabulary& vocabulary,
                     const char* empty) {
  std::vector<std::string> texts;
  for (const Literal& literal : literals) {
    texts.push_back(ToText(literal, vocabulary, variables));
  }
  return texts.empty() ? empty : fmt::format("{}", fmt::join(texts, ", "));
}

/// The rule's variables, with the names of the objects that they stand for.
Variables NamesOf(const Action& action, const NdrRule& rule,
                  const Binding& binding, const Vocabulary& vocabulary) {
  Variables variables = action.arguments;
  for (const DeicticReference& reference : rule.references) {
    variables.push_back(reference.variable);
  }
  for (size_t i = 0; i < binding.size() && i < variables.size(); ++i) {
    variables[i].name = vocabulary.objects()[binding[i]].name;
  }
  return variables;
}

std::string ReferencesText(const NdrRule& rule, size_t num_arguments,
                           const Variables& variables,
                           const Vocabulary& vocabulary) {
  std::vector<std::string> texts;
  for (size_t i = 0; i < rule.references.size(); ++i) {
    const DeicticReference& reference = rule.references[i];
    const std::string& name = variables[num_arguments + i].name;
    texts.push_back(reference.variable.name +
                    (name == reference.variable.name ? "" : " = " + name) +
                    ": " +
                    ListText(reference.literals, variables, vocabulary, "any"));
  }
  return fmt::format("References: {}", fmt::join(texts, "; "));
}

std::string EachText(const Effect& effect, Variables variables,
                     const Vocabulary& vocabulary) {
  std::vector<std::string> names;
  for (const Variable& variable : effect.each) names.push_back(variable.name);
  variables.insert(variables.end(), effect.each.begin(), effect.each.end());
  std::string text =
      fmt::format("    each {}: {}", fmt::join(names, ", "),
                  ListText(effect.then, variables, vocabulary, "nothing"));
  if (!effect.where.empty()) {
    text += " if " + ListText(effect.where, variables, vocabulary, "");
  }
  return text;
}

void AddOutcome(const Outcome& outcome, const Variables& variables,
                const Vocabulary& vocabulary, std::vector<std::string>* lines) {
  std::vector<Literal> changes;
  for (const Effect& effect : outcome.effects) {
    if (!effect.each.empty()) continue;
    changes.insert(changes.end(), effect.then.begin(), effect.then.end());
  }
  lines->push_back(
      fmt::format("  {:.2f}: {}", outcome.probability,
                  ListText(changes, variables, vocabulary, "nothing")));
  for (const Effect& effect : outcome.effects) {
    if (effect.each.empty()) continue;
    lines->push_back(EachText(effect, variables, vocabulary));
  }
}

}  // namespace

std::vector<std::string> RuleLines(const Action& action, const NdrRule& rule,
                                   const Binding& binding,
                                   const Vocabulary& vocabulary) {
  const Variables variables = NamesOf(action, rule, binding, vocabulary);
  const size_t num_arguments = action.arguments.size();
  std::vector<std::string> arguments;
  for (size_t i = 0; i < num_arguments; ++i) {
    arguments.push_back(variables[i].name);
  }
  std::vector<std::string> lines = {
      fmt::format("Action: {}({})", action.name, fmt::join(arguments, ", "))};
  if (!rule.references.empty()) {
    lines.push_back(ReferencesText(rule, num_arguments, variables, vocabulary));
  }
  lines.push_back("Preconditions: " +
                  ListText(rule.context, variables, vocabulary, "none"));
  lines.emplace_back("Effects:");
  for (const Outcome& outcome : rule.outcomes) {
    AddOutcome(outcome, variables, vocabulary, &lines);
  }
  lines.push_back(fmt::format("  {:.2f}: noise", rule.noise));
  return lines;
}

}  // namespace cell
