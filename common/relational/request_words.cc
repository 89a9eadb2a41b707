#include "common/relational/request_words.h"

#include <algorithm>
#include <functional>

#include "common/text/nearest.h"

namespace cell {
namespace {

/// What stands for argument `i`.
std::string PlaceOf(size_t i) {
  return "{" + std::to_string(i) + "}";
}

std::string Filled(std::string words, const std::vector<std::string>& names) {
  for (size_t i = 0; i < names.size(); ++i) {
    const std::string place = PlaceOf(i);
    for (size_t at = words.find(place); at != std::string::npos;
         at = words.find(place, at + names[i].size())) {
      words.replace(at, place.size(), names[i]);
    }
  }
  return words;
}

/// @throws ConfigError unless each brace belongs to the place of an argument.
void CheckPlaces(const Config& config, std::string words,
                 size_t num_arguments) {
  std::string places;
  for (size_t i = 0; i < num_arguments; ++i) {
    const std::string place = PlaceOf(i);
    places += (i == 0 ? "" : ", ") + place;
    for (size_t at = words.find(place); at != std::string::npos;
         at = words.find(place)) {
      words.erase(at, place.size());
    }
  }
  if (words.find_first_of("{}") == std::string::npos) return;
  config.Fail(num_arguments == 0 ? "it has no arguments: no braces"
                                 : "its arguments are " + places);
}

std::vector<std::string> NamesOf(const std::vector<int>& objects,
                                 const Vocabulary& vocabulary) {
  std::vector<std::string> names;
  for (const int object : objects) {
    names.push_back(vocabulary.objects()[object].name);
  }
  return names;
}

/// `num_arguments_of` a name: nothing if there is no such name.
std::map<std::string, std::string> LoadTemplates(
    const Config& section, const std::string& key, const char* what,
    const std::vector<std::string>& names,
    const std::function<size_t(size_t index)>& num_arguments_of) {
  std::map<std::string, std::string> templates;
  if (!section.Has(key)) return templates;
  for (const auto& [name, node] : section[key].Entries()) {
    const auto it = std::ranges::find(names, name);
    if (it == names.end()) {
      node.Fail(std::string("there is no ") + what + " of this name" +
                NamesInstead(name, names));
    }
    const auto words = node.As<std::string>();
    CheckPlaces(node, words,
                num_arguments_of(static_cast<size_t>(it - names.begin())));
    templates[name] = words;
  }
  return templates;
}

}  // namespace

RequestWords RequestWords::FromConfig(const Config& config,
                                      const Vocabulary& vocabulary,
                                      const std::vector<Action>& actions) {
  RequestWords words;
  if (!config.Has("requests")) return words;
  const Config section = config["requests"];
  const auto predicates = NamesIn(vocabulary.predicates(), &Predicate::name);
  const auto arity = [&](size_t i) {
    return vocabulary.predicates()[i].argument_types.size();
  };
  words.make_true_ =
      LoadTemplates(section, "make_true", "predicate", predicates, arity);
  words.make_false_ =
      LoadTemplates(section, "make_false", "predicate", predicates, arity);
  words.do_ =
      LoadTemplates(section, "do", "action", NamesIn(actions, &Action::name),
                    [&](size_t i) { return actions[i].arguments.size(); });
  return words;
}

std::optional<std::string> RequestWords::ToMake(
    const GroundAtom& atom, bool is_true, const Vocabulary& vocabulary) const {
  const Templates& templates = is_true ? make_true_ : make_false_;
  const auto it = templates.find(vocabulary.predicates()[atom.predicate].name);
  if (it == templates.end()) return std::nullopt;
  return Filled(it->second, NamesOf(atom.objects, vocabulary));
}

std::optional<std::string> RequestWords::ToMake(
    const Literal& literal, const Vocabulary& vocabulary) const {
  if (literal.is_static) return std::nullopt;
  const Predicate& predicate = vocabulary.predicates()[literal.relation];
  const Templates& templates = literal.is_negated ? make_false_ : make_true_;
  const auto it = templates.find(predicate.name);
  if (it == templates.end()) return std::nullopt;
  std::vector<std::string> names;
  for (size_t i = 0; i < literal.terms.size(); ++i) {
    names.push_back(literal.terms[i].kind == Term::Kind::kObject
                        ? vocabulary.objects()[literal.terms[i].index].name
                        : vocabulary.types().name(predicate.argument_types[i]));
  }
  return Filled(it->second, names);
}

std::optional<std::string> RequestWords::ToDo(
    const std::string& action, const std::vector<int>& objects,
    const Vocabulary& vocabulary) const {
  const auto it = do_.find(action);
  if (it == do_.end()) return std::nullopt;
  return Filled(it->second, NamesOf(objects, vocabulary));
}

}  // namespace cell
