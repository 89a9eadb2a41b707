#include "common/rexd/ppddl_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "common/rules/rule_error.h"

namespace cell::rexd {
namespace {

struct NoWords {
  std::string text;
};

/// Changes with their probability, as rules write them.
struct WrittenOutcome {
  double probability = 1;
  std::vector<std::string> removed;
  std::vector<std::string> added;
};

/// Writes the problem as ParseRexdTask() reads it.
class RexdTaskWriter {
 public:
  RexdTaskWriter(const ppddl::Domain& domain, const ppddl::Problem& problem)
      : domain_(domain), problem_(problem) {}

  std::string Write() {
    std::string text = "objects:";
    for (const ppddl::Object& object : problem_.objects) {
      text += " " + Name(object.name);
    }
    text += "\nstart:" + Start() + "\ngoal:" + Goal() + "\n";
    for (const ppddl::Object& object : domain_.constants) {
      text += Name(object.name) + " 0 constant\n";
    }
    return text + Symbols() + Rules();
  }

 private:
  static std::string Name(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
  }

  static std::string Variable(size_t index) {
    return std::string(1, "XYZ"[index]);
  }

  const ppddl::Object& ObjectAt(int index) const {
    const auto i = static_cast<size_t>(index);
    const size_t n = domain_.constants.size();
    return i < n ? domain_.constants[i] : problem_.objects[i - n];
  }

  std::string TermText(const ppddl::Term& term) const {
    return term.is_variable ? Variable(static_cast<size_t>(term.index))
                            : Name(ObjectAt(term.index).name);
  }

  std::string AtomText(int predicate,
                       const std::vector<ppddl::Term>& terms) const {
    const auto i = static_cast<size_t>(predicate);
    std::string text = Name(domain_.predicates[i].name) + "(";
    for (size_t k = 0; k < terms.size(); ++k) {
      text += (k > 0 ? ", " : "") + TermText(terms[k]);
    }
    return text + ")";
  }

  std::string Start() const {
    std::string text;
    const size_t num_objects =
        domain_.constants.size() + problem_.objects.size();
    for (size_t i = 0; i < num_objects; ++i) {
      const ppddl::Object& object = ObjectAt(static_cast<int>(i));
      for (int type = object.type; type != 0;
           type = domain_.types[static_cast<size_t>(type)].parent) {
        text += fmt::format(" {}({})", TypeName(type), Name(object.name));
      }
    }
    for (const ppddl::GroundAtom& atom : problem_.init) {
      std::vector<ppddl::Term> terms;
      for (const int object : atom.objects) terms.push_back({false, object});
      text += " " + AtomText(atom.predicate, terms);
    }
    return text;
  }

  std::string TypeName(int type) const {
    return Name(domain_.types[static_cast<size_t>(type)].name);
  }

  std::string Goal() const {
    std::string text;
    ForEachLiteral(problem_.goal, "the goal",
                   [&](const ppddl::Condition& atom, bool is_true) {
                     if (atom.kind != ppddl::Condition::Kind::kAtom) {
                       throw NoWords{"the goal compares objects"};
                     }
                     text += is_true ? " " : " -";
                     text += AtomText(atom.predicate, atom.terms);
                   });
    return text;
  }

  /// Calls visit(atom or equality, whether it is to hold).
  template <class Visit>
  static void ForEachLiteral(const ppddl::Condition& condition,
                             const std::string& where, const Visit& visit) {
    using Kind = ppddl::Condition::Kind;
    const auto is_plain = [](const ppddl::Condition& c) {
      return c.kind == Kind::kAtom || c.kind == Kind::kEqual;
    };
    if (is_plain(condition)) return visit(condition, true);
    if (condition.kind == Kind::kNot && is_plain(condition.parts[0])) {
      return visit(condition.parts[0], false);
    }
    if (condition.kind != Kind::kAnd) {
      throw NoWords{where + ": its condition is no conjunction of literals"};
    }
    for (const ppddl::Condition& part : condition.parts) {
      ForEachLiteral(part, where, visit);
    }
  }

  std::string Symbols() const {
    std::string text;
    std::set<std::string> names;
    const auto add = [&](const std::string& name, size_t arity,
                         const std::string& kind) {
      if (!names.insert(name).second) {
        throw NoWords{"two types, predicates or actions are named '" + name +
                      "'"};
      }
      if (arity > rules::kMaxArity) {
        throw NoWords{
            fmt::format("'{}' has {} arguments; rules have at most "
                        "{}",
                        name, arity, rules::kMaxArity)};
      }
      text += fmt::format("{} {} {}\n", name, arity, kind);
    };
    for (size_t type = 1; type < domain_.types.size(); ++type) {
      add(TypeName(static_cast<int>(type)), 1, "primitive");
    }
    for (const ppddl::Symbol& predicate : domain_.predicates) {
      add(Name(predicate.name), predicate.parameters.size(), "primitive");
    }
    for (const ppddl::Action& action : domain_.actions) {
      add(Name(action.name), action.parameters.size(),
          "action" + TypesOf(action));
    }
    return text;
  }

  std::string TypesOf(const ppddl::Action& action) const {
    std::string text;
    for (size_t i = 0; i < action.parameters.size(); ++i) {
      const int type = action.parameters[i].type;
      if (type == 0 || i >= rules::kMaxArity) continue;
      text += fmt::format(" {}({})", TypeName(type), Variable(i));
    }
    return text.empty() ? "" : " <--" + text;
  }

  std::string Rules() const {
    std::string text;
    for (const ppddl::Action& action : domain_.actions) {
      const std::string name = Name(action.name);
      std::string arguments;
      for (size_t i = 0; i < action.parameters.size(); ++i) {
        arguments += (i > 0 ? ", " : "") + Variable(i);
      }
      text += fmt::format("\nAction: {}({})\nPreconditions: {}\nEffects:\n{}",
                          name, arguments,
                          Precondition(action, "action '" + action.name + "'"),
                          Outcomes(action, "action '" + action.name + "'"));
    }
    return text;
  }

  std::string Precondition(const ppddl::Action& action,
                           const std::string& where) const {
    std::string text;
    ForEachLiteral(action.precondition, where,
                   [&](const ppddl::Condition& atom, bool is_true) {
                     if (!text.empty()) text += ", ";
                     if (atom.kind == ppddl::Condition::Kind::kEqual) {
                       text += TermText(atom.terms[0]) +
                               (is_true ? " = " : " != ") +
                               TermText(atom.terms[1]);
                     } else {
                       text += (is_true ? "" : "not ") +
                               AtomText(atom.predicate, atom.terms);
                     }
                   });
    return text.empty() ? "none" : text;
  }

  std::string Outcomes(const ppddl::Action& action,
                       const std::string& where) const {
    std::string text;
    double noise = 1;
    for (const WrittenOutcome& outcome : OutcomesOf(action.effect, where)) {
      // What is deleted and added is there afterwards.
      std::string changes;
      for (const auto* list : {&outcome.removed, &outcome.added}) {
        for (const std::string& atom : *list) {
          changes += changes.empty() ? "" : ", ";
          changes += (list == &outcome.removed ? "not " : "") + atom;
        }
      }
      text += fmt::format("  {}: {}\n", outcome.probability,
                          changes.empty() ? "nothing" : changes);
      noise -= outcome.probability;
    }
    return text + fmt::format("  {}: noise\n", std::max(0.0, noise));
  }

  std::vector<WrittenOutcome> OutcomesOf(const ppddl::Effect& effect,
                                         const std::string& where) const {
    using Kind = ppddl::Effect::Kind;
    switch (effect.kind) {
      case Kind::kAdd:
        return {{1, {}, {AtomText(effect.symbol, effect.terms)}}};
      case Kind::kDelete:
        return {{1, {AtomText(effect.symbol, effect.terms)}, {}}};
      case Kind::kIncrease:
      case Kind::kDecrease:
        return {WrittenOutcome()};
      case Kind::kAnd:
        return Jointly(effect, where);
      case Kind::kProbabilistic:
        return OneOf(effect, where);
      case Kind::kWhen:
      case Kind::kForall:
        break;
    }
    throw NoWords{where + ": its effects have a condition or a quantifier"};
  }

  std::vector<WrittenOutcome> Jointly(const ppddl::Effect& effect,
                                      const std::string& where) const {
    std::vector<WrittenOutcome> joint = {WrittenOutcome()};
    for (const ppddl::Effect& part : effect.parts) {
      std::vector<WrittenOutcome> next;
      for (const WrittenOutcome& before : joint) {
        for (const WrittenOutcome& one : OutcomesOf(part, where)) {
          WrittenOutcome both = before;
          both.probability *= one.probability;
          std::ranges::copy(one.removed, std::back_inserter(both.removed));
          std::ranges::copy(one.added, std::back_inserter(both.added));
          next.push_back(std::move(both));
        }
      }
      joint = std::move(next);
    }
    return joint;
  }

  std::vector<WrittenOutcome> OneOf(const ppddl::Effect& effect,
                                    const std::string& where) const {
    std::vector<WrittenOutcome> all;
    double rest = 1;
    for (size_t i = 0; i < effect.parts.size(); ++i) {
      for (WrittenOutcome& one : OutcomesOf(effect.parts[i], where)) {
        one.probability *= effect.probabilities[i];
        all.push_back(std::move(one));
      }
      rest -= effect.probabilities[i];
    }
    if (rest > 1e-9) all.push_back({rest, {}, {}});
    return all;
  }

  const ppddl::Domain& domain_;
  const ppddl::Problem& problem_;
};

}  // namespace

Result<RexdTask> FromPpddl(const ppddl::Domain& domain,
                           const ppddl::Problem& problem) {
  try {
    return ParseRexdTask(RexdTaskWriter(domain, problem).Write(), problem.name);
  } catch (const NoWords& no) {
    return Reason{no.text};
  } catch (const rules::RuleError& error) {
    return Reason{error.what()};
  }
}

}  // namespace cell::rexd
