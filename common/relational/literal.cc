#include "common/relational/literal.h"

#include <fmt/format.h>

#include <cctype>
#include <utility>

namespace cell {
namespace {

std::string Trim(const std::string& text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// What a literal is made of, as words.
struct Words {
  std::string name;
  std::vector<std::string> terms;
  bool is_negated = false;
};

Words Split(const Config& config) {
  Words words;
  std::string text = Trim(config.As<std::string>());
  if (text.starts_with("not ")) {
    words.is_negated = true;
    text = Trim(text.substr(4));
  }
  const size_t open = text.find('(');
  if (open == std::string::npos || text.find(')') != text.size() - 1) {
    config.Fail("'" + text + "' should read Name(A, b, _) or not Name(...)");
  }
  words.name = Trim(text.substr(0, open));
  std::string inner = text.substr(open + 1, text.size() - open - 2);
  while (!Trim(inner).empty()) {
    const size_t comma = inner.find(',');
    words.terms.push_back(Trim(inner.substr(0, comma)));
    inner = comma == std::string::npos ? "" : inner.substr(comma + 1);
  }
  return words;
}

/// The term and its type; of `_` any type.
Term ParseTerm(const std::string& word, int type, const Config& config,
               const Vocabulary& vocabulary,
               std::span<const Variable> variables) {
  if (word == "_") return {Term::Kind::kAny, 0};
  Term term{Term::Kind::kObject, 0};
  int type_of_term = TypeHierarchy::kObject;
  if (std::isupper(static_cast<unsigned char>(word[0]))) {
    term.kind = Term::Kind::kVariable;
    for (; term.index < static_cast<int>(variables.size()); ++term.index) {
      if (variables[term.index].name == word) break;
    }
    if (term.index == static_cast<int>(variables.size())) {
      config.Fail("the variable '" + word + "' is not known here");
    }
    type_of_term = variables[term.index].type;
  } else {
    const std::optional<int> object = vocabulary.FindObject(word);
    if (!object) config.Fail("there is no object '" + word + "'");
    term.index = *object;
    type_of_term = vocabulary.objects()[*object].type;
  }
  if (!vocabulary.types().IsA(type_of_term, type)) {
    config.Fail(fmt::format("'{}' is a {}, not a {}", word,
                            vocabulary.types().name(type_of_term),
                            vocabulary.types().name(type)));
  }
  return term;
}

/// Calls `visit` with all objects that the terms may stand for until it
/// returns false.
template <class Visit>
void ForEachGrounding(const Literal& literal,
                      const std::vector<int>& argument_types,
                      const Binding& binding, const Vocabulary& vocabulary,
                      Visit visit) {
  const size_t size = literal.terms.size();
  std::vector<int> objects(size);
  std::vector<size_t> choice(size, 0);
  for (;;) {
    for (size_t i = 0; i < size; ++i) {
      const Term& term = literal.terms[i];
      if (term.kind == Term::Kind::kAny) {
        const auto& all = vocabulary.ObjectsOf(argument_types[i]);
        if (all.empty()) return;
        objects[i] = all[choice[i]];
      } else {
        objects[i] = term.kind == Term::Kind::kObject ? term.index
                                                      : binding.at(term.index);
      }
    }
    if (!visit(objects)) return;
    size_t i = 0;  // next choice for the `_`, as an odometer
    for (; i < size; ++i) {
      if (literal.terms[i].kind != Term::Kind::kAny) continue;
      if (++choice[i] < vocabulary.ObjectsOf(argument_types[i]).size()) break;
      choice[i] = 0;
    }
    if (i == size) return;
  }
}

/// Truth of the literal without its negation.
Truth TruthOfAtom(const Literal& literal, const Binding& binding,
                  const State& state, const Vocabulary& vocabulary) {
  Truth truth = Truth::kFalse;
  if (literal.is_static) {
    const StaticRelation& relation =
        vocabulary.static_relations()[literal.relation];
    ForEachGrounding(literal, relation.argument_types, binding, vocabulary,
                     [&](const std::vector<int>& objects) {
                       if (!relation.facts.contains(objects)) return true;
                       truth = Truth::kTrue;
                       return false;
                     });
    return truth;
  }
  const Predicate& predicate = vocabulary.predicates()[literal.relation];
  ForEachGrounding(literal, predicate.argument_types, binding, vocabulary,
                   [&](const std::vector<int>& objects) {
                     const auto atom =
                         vocabulary.AtomIndex(literal.relation, objects);
                     if (!atom) return true;
                     const Truth here = state.Get(*atom);
                     if (here != Truth::kFalse) truth = here;
                     return truth != Truth::kTrue;
                   });
  return truth;
}

}  // namespace

Term ParseTerm(const Config& config, int type, const Vocabulary& vocabulary,
               std::span<const Variable> variables) {
  const auto word = config.As<std::string>();
  if (word.empty()) config.Fail("is empty");
  return ParseTerm(word, type, config, vocabulary, variables);
}

Literal ParseLiteral(const Config& config, const Vocabulary& vocabulary,
                     std::span<const Variable> variables) {
  const Words words = Split(config);
  const auto predicate = vocabulary.FindPredicate(words.name);
  const auto fact = vocabulary.FindStatic(words.name);
  if (!predicate && !fact) {
    config.Fail("there is no predicate, static fact or type '" + words.name +
                "'");
  }
  Literal literal;
  literal.is_static = !predicate;
  literal.relation = predicate ? *predicate : *fact;
  literal.is_negated = words.is_negated;
  const std::vector<int>& types =
      predicate ? vocabulary.predicates()[*predicate].argument_types
                : vocabulary.static_relations()[*fact].argument_types;
  if (words.terms.size() != types.size()) {
    config.Fail(fmt::format("'{}' takes {} arguments, not {}", words.name,
                            types.size(), words.terms.size()));
  }
  for (size_t i = 0; i < types.size(); ++i) {
    if (words.terms[i].empty()) config.Fail("an argument is empty");
    literal.terms.push_back(
        ParseTerm(words.terms[i], types[i], config, vocabulary, variables));
  }
  return literal;
}

bool Contradict(const Literal& a, const Literal& b) {
  if (a.is_negated == b.is_negated || a.is_static != b.is_static ||
      a.relation != b.relation) {
    return false;
  }
  const Literal& negated = a.is_negated ? a : b;
  const Literal& other = a.is_negated ? b : a;
  for (size_t i = 0; i < negated.terms.size(); ++i) {
    // `_` of the negated one: no object at all.
    if (negated.terms[i].kind != Term::Kind::kAny &&
        negated.terms[i] != other.terms[i]) {
      return false;
    }
  }
  return true;
}

std::vector<Literal> ParseLiterals(const Config& config,
                                   const Vocabulary& vocabulary,
                                   std::span<const Variable> variables) {
  std::vector<Literal> literals;
  for (const Config& item : config.Items()) {
    const Literal literal = ParseLiteral(item, vocabulary, variables);
    for (const Literal& other : literals) {
      if (literal == other) item.Fail("is in the list twice");
      if (Contradict(literal, other)) {
        item.Fail(
            "contradicts another literal of the list: they never hold "
            "together");
      }
    }
    literals.push_back(literal);
  }
  return literals;
}

bool MayHold(const Literal& literal, const Binding& binding, const State& state,
             const Vocabulary& vocabulary) {
  const Truth truth = TruthOfAtom(literal, binding, state, vocabulary);
  return truth == Truth::kUnknown ||
         (truth == Truth::kTrue) != literal.is_negated;
}

bool MayHold(std::span<const Literal> literals, const Binding& binding,
             const State& state, const Vocabulary& vocabulary) {
  for (const Literal& literal : literals) {
    if (!MayHold(literal, binding, state, vocabulary)) return false;
  }
  return true;
}

bool MustHold(const Literal& literal, const Binding& binding,
              const State& state, const Vocabulary& vocabulary) {
  const Truth truth = TruthOfAtom(literal, binding, state, vocabulary);
  return truth != Truth::kUnknown &&
         (truth == Truth::kTrue) != literal.is_negated;
}

std::vector<int> Groundings(const Literal& literal, const Binding& binding,
                            const Vocabulary& vocabulary) {
  std::vector<int> atoms;
  if (literal.is_static) return atoms;
  const Predicate& predicate = vocabulary.predicates()[literal.relation];
  ForEachGrounding(literal, predicate.argument_types, binding, vocabulary,
                   [&](const std::vector<int>& objects) {
                     const auto atom =
                         vocabulary.AtomIndex(literal.relation, objects);
                     if (atom) atoms.push_back(*atom);
                     return true;
                   });
  return atoms;
}

std::string ToText(const Term& term, const Vocabulary& vocabulary,
                   std::span<const Variable> variables) {
  switch (term.kind) {
    case Term::Kind::kVariable:
      return variables[static_cast<size_t>(term.index)].name;
    case Term::Kind::kObject:
      return vocabulary.objects().at(term.index).name;
    case Term::Kind::kAny:
      break;
  }
  return "_";
}

std::string ToText(const Literal& literal, const Vocabulary& vocabulary,
                   std::span<const Variable> variables) {
  std::string text = literal.is_negated ? "not " : "";
  text += literal.is_static
              ? vocabulary.static_relations()[literal.relation].name
              : vocabulary.predicates()[literal.relation].name;
  text += "(";
  for (size_t i = 0; i < literal.terms.size(); ++i) {
    text +=
        (i > 0 ? ", " : "") + ToText(literal.terms[i], vocabulary, variables);
  }
  return text + ")";
}

std::string Show(const Literal& literal, const Binding& binding,
                 const Vocabulary& vocabulary) {
  std::vector<Variable> objects;
  for (const int object : binding) {
    const Object& bound = vocabulary.objects()[object];
    objects.push_back({bound.name, bound.type});
  }
  return ToText(literal, vocabulary, objects);
}

}  // namespace cell
