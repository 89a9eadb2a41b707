#include <fmt/format.h>

#include <iterator>
#include <string>
#include <vector>

#include "common/ppddl/problem.h"

namespace cell::ppddl {
namespace {

/// "a - block b - table", one by one, so that the order stays.
template <class Named>
std::string TypedList(const std::vector<Named>& named, const Domain& domain) {
  std::string text;
  for (const Named& element : named) {
    text += (text.empty() ? "" : " ") + element.name + " - " +
            domain.types[static_cast<size_t>(element.type)].name;
  }
  return text;
}

/// Writes formulas in which variables and objects have these names.
class FormulaWriter {
 public:
  FormulaWriter(const Domain& domain, const std::vector<Object>& objects,
                const std::vector<Variable>& variables)
      : domain_(domain), variables_(variables) {
    for (const auto* list : {&domain.constants, &objects}) {
      for (const Object& object : *list) objects_.push_back(object.name);
    }
  }

  std::string Write(const Condition& condition) {
    using enum Condition::Kind;
    switch (condition.kind) {
      case kAtom:
        return Symbol(domain_.predicates, condition.predicate, condition.terms);
      case kEqual:
        return "(=" + Terms(condition.terms) + ")";
      case kNot:
        return "(not" + Parts(condition.parts) + ")";
      case kAnd:
        return "(and" + Parts(condition.parts) + ")";
      case kOr:
        return "(or" + Parts(condition.parts) + ")";
      case kImply:
        return "(imply" + Parts(condition.parts) + ")";
      case kForall:
        return Quantified("forall", condition);
      case kExists:
        return Quantified("exists", condition);
    }
    return {};
  }

  std::string Write(const Effect& effect) {
    using enum Effect::Kind;
    switch (effect.kind) {
      case kAdd:
        return Symbol(domain_.predicates, effect.symbol, effect.terms);
      case kDelete:
        return "(not " +
               Symbol(domain_.predicates, effect.symbol, effect.terms) + ")";
      case kAnd:
        return "(and" + Parts(effect.parts) + ")";
      case kWhen:
        return "(when " + Write(effect.condition) + Parts(effect.parts) + ")";
      case kForall:
        return Quantified("forall", effect);
      case kProbabilistic:
        return Probabilistic(effect);
      case kIncrease:
        return Numeric("increase", effect);
      case kDecrease:
        return Numeric("decrease", effect);
    }
    return {};
  }

 private:
  std::string Terms(const std::vector<Term>& terms) const {
    std::string text;
    for (const Term& term : terms) {
      const auto index = static_cast<size_t>(term.index);
      text +=
          " " + (term.is_variable ? variables_[index].name : objects_[index]);
    }
    return text;
  }

  std::string Symbol(const std::vector<ppddl::Symbol>& symbols, int index,
                     const std::vector<Term>& terms) const {
    return "(" + symbols[static_cast<size_t>(index)].name + Terms(terms) + ")";
  }

  template <class Formula>
  std::string Parts(const std::vector<Formula>& parts) {
    std::string text;
    for (const Formula& part : parts) text += " " + Write(part);
    return text;
  }

  template <class Formula>
  std::string Quantified(const std::string& word, const Formula& formula) {
    std::string text =
        "(" + word + " (" + TypedList(formula.variables, domain_) + ")";
    variables_.insert(variables_.end(), formula.variables.begin(),
                      formula.variables.end());
    text += Parts(formula.parts) + ")";
    variables_.resize(variables_.size() - formula.variables.size());
    return text;
  }

  std::string Probabilistic(const Effect& effect) {
    std::string text = "(probabilistic";
    for (size_t i = 0; i < effect.parts.size(); ++i) {
      text += fmt::format(" {} {}", effect.probabilities[i],
                          Write(effect.parts[i]));
    }
    return text + ")";
  }

  std::string Numeric(const std::string& word, const Effect& effect) const {
    const Amount& amount = effect.amount;
    return "(" + word + " " +
           Symbol(domain_.functions, effect.symbol, effect.terms) + " " +
           (amount.is_number
                ? fmt::format("{}", amount.number)
                : Symbol(domain_.functions, amount.function, amount.terms)) +
           ")";
  }

  const Domain& domain_;
  std::vector<Variable> variables_;
  std::vector<std::string> objects_;
};

std::string Symbols(const std::vector<Symbol>& symbols, const Domain& domain) {
  std::string text;
  for (const Symbol& symbol : symbols) {
    text += " (" + symbol.name + (symbol.parameters.empty() ? "" : " ") +
            TypedList(symbol.parameters, domain) + ")";
  }
  return text;
}

std::string Requirements(const std::vector<std::string>& requirements) {
  std::string text;
  for (const std::string& word : requirements) text += " " + word;
  return text.empty() ? "" : "  (:requirements" + text + ")\n";
}

std::string Types(const Domain& domain) {
  // The parent of object is object; it is not written.
  std::string text;
  for (size_t i = 1; i < domain.types.size(); ++i) {
    const Type& type = domain.types[i];
    text += " " + type.name + " - " +
            domain.types[static_cast<size_t>(type.parent)].name;
  }
  return text.empty() ? "" : "  (:types" + text + ")\n";
}

std::string Write(const Action& action, const Domain& domain) {
  FormulaWriter writer(domain, {}, action.parameters);
  return "  (:action " + action.name + "\n    :parameters (" +
         TypedList(action.parameters, domain) + ")\n    :precondition " +
         writer.Write(action.precondition) + "\n    :effect " +
         writer.Write(action.effect) + ")\n";
}

std::string Names(const std::vector<int>& objects, const Domain& domain,
                  const Problem& problem, const std::string& between) {
  std::string text;
  const size_t num_constants = domain.constants.size();
  for (const int object : objects) {
    const auto index = static_cast<size_t>(object);
    text += (text.empty() ? "" : between) +
            (index < num_constants ? domain.constants[index]
                                   : problem.objects[index - num_constants])
                .name;
  }
  return text;
}

std::string Init(const Problem& problem, const Domain& domain) {
  const auto write = [&](const Symbol& symbol,
                         const std::vector<int>& objects) {
    return "(" + symbol.name + (objects.empty() ? "" : " ") +
           Names(objects, domain, problem, " ") + ")";
  };
  std::string text = "  (:init";
  for (const GroundAtom& atom : problem.init) {
    text +=
        "\n    " + write(domain.predicates[static_cast<size_t>(atom.predicate)],
                         atom.objects);
  }
  for (const FunctionValue& value : problem.values) {
    text +=
        fmt::format("\n    (= {} {})",
                    write(domain.functions[static_cast<size_t>(value.function)],
                          value.objects),
                    value.value);
  }
  return text + ")\n";
}

}  // namespace

std::string ToText(const Domain& domain) {
  std::string text = "(define (domain " + domain.name + ")\n" +
                     Requirements(domain.requirements) + Types(domain);
  if (!domain.constants.empty()) {
    text += "  (:constants " + TypedList(domain.constants, domain) + ")\n";
  }
  text += "  (:predicates" + Symbols(domain.predicates, domain) + ")\n";
  text += "  (:functions" + Symbols(domain.functions, domain) + ")\n";
  for (const Action& action : domain.actions) text += Write(action, domain);
  return text + ")\n";
}

std::string ToText(const Problem& problem, const Domain& domain) {
  std::string text = "(define (problem " + problem.name + ")\n  (:domain " +
                     problem.domain_name + ")\n" +
                     Requirements(problem.requirements);
  if (!problem.objects.empty()) {
    text += "  (:objects " + TypedList(problem.objects, domain) + ")\n";
  }
  text += Init(problem, domain);
  text += "  (:goal " +
          FormulaWriter(domain, problem.objects, {}).Write(problem.goal) +
          ")\n";
  if (problem.goal_reward) {
    text += fmt::format("  (:goal-reward {})\n", *problem.goal_reward);
  }
  if (problem.metric) {
    text += fmt::format(
        "  (:metric {} ({}))\n",
        problem.metric->is_maximized ? "maximize" : "minimize",
        domain.functions[static_cast<size_t>(problem.metric->function)].name);
  }
  return text + ")\n";
}

std::string Show(const GroundAtom& atom, const Domain& domain,
                 const Problem& problem) {
  return domain.predicates[static_cast<size_t>(atom.predicate)].name + "(" +
         Names(atom.objects, domain, problem, ", ") + ")";
}

}  // namespace cell::ppddl
