#include "common/sec/sec_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "common/scene/scene_objects.h"

namespace cell {
namespace {

class Reader {
 public:
  Reader(std::span<const Variable> arguments, const Vocabulary& vocabulary,
         const PartTable& parts)
      : arguments_(arguments), vocabulary_(vocabulary), parts_(parts) {}

  SceneCondition ReadCondition(const Config& config) const {
    SceneCondition condition;
    if (config.Has("touch")) condition.touch = ReadPairs(config["touch"]);
    if (config.Has("apart")) condition.apart = ReadPairs(config["apart"]);
    if (config.Has("where")) {
      condition.where = ParseLiterals(config["where"], vocabulary_, arguments_);
    }
    return condition;
  }

  SceneCondition::Role ReadRole(const Config& config) const {
    const auto name = config.As<std::string>();
    for (size_t i = 0; i < arguments_.size(); ++i) {
      if (arguments_[i].name == name) return i;
    }
    if (name != SceneObjects::kTable && !parts_.Find(name)) {
      config.Fail("'" + name + "' is not an argument, part or table");
    }
    return name;
  }

 private:
  std::vector<SceneCondition::Pair> ReadPairs(const Config& config) const {
    std::vector<SceneCondition::Pair> pairs;
    for (const Config& item : config.Items()) {
      const std::vector<Config> names = item.Items();
      if (names.size() != 2) item.Fail("needs two names");
      pairs.push_back({ReadRole(names[0]), ReadRole(names[1])});
    }
    return pairs;
  }

  std::span<const Variable> arguments_;
  const Vocabulary& vocabulary_;
  const PartTable& parts_;
};

/// The arguments that the condition speaks of.
std::set<size_t> ArgumentsIn(const SceneCondition& condition) {
  std::set<size_t> arguments;
  for (const auto* pairs : {&condition.touch, &condition.apart}) {
    for (const SceneCondition::Pair& pair : *pairs) {
      for (const SceneCondition::Role& role : pair) {
        const auto* argument = std::get_if<size_t>(&role);
        if (argument) arguments.insert(*argument);
      }
    }
  }
  for (const Literal& literal : condition.where) {
    for (const Term& term : literal.terms) {
      if (term.kind != Term::Kind::kVariable) continue;
      arguments.insert(static_cast<size_t>(term.index));
    }
  }
  return arguments;
}

}  // namespace

SecConditions SecConditions::FromConfig(const Config& config,
                                        std::span<const Variable> arguments,
                                        const Vocabulary& vocabulary,
                                        const PartTable& parts) {
  const Reader reader(arguments, vocabulary, parts);
  const SceneCondition::Role moved = reader.ReadRole(config["moved"]);
  if (!std::holds_alternative<size_t>(moved)) {
    config["moved"].Fail("must be an argument of the action");
  }
  SecConditions conditions{std::get<size_t>(moved),
                           reader.ReadCondition(config["pick"]),
                           reader.ReadCondition(config["place"])};
  const std::string& name = arguments[conditions.moved].name;
  std::set<size_t> mentioned = ArgumentsIn(conditions.place);
  if (!mentioned.contains(conditions.moved)) {
    config["place"].Fail("does not mention " + name + ", which is moved");
  }
  if (!ArgumentsIn(conditions.pick).contains(conditions.moved)) {
    config["pick"].Fail("does not mention " + name + ", which is moved");
  }
  mentioned.merge(ArgumentsIn(conditions.pick));
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (mentioned.contains(i)) continue;
    config.Fail(fmt::format(
        "neither pick nor place mentions {}: any object would match",
        arguments[i].name));
  }
  return conditions;
}

}  // namespace cell
