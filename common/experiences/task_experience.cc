#include "common/experiences/task_experience.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "common/text/nearest.h"

namespace cell {
namespace {

constexpr char kPersonWord[] = "person";
constexpr char kRobotWord[] = "robot";

std::vector<literal_t> LiteralsOf(const State& state,
                                  const Vocabulary& vocabulary) {
  std::vector<literal_t> literals;
  for (int i = 0; i < state.num_atoms(); ++i) {
    const Truth truth = state.Get(i);
    if (truth == Truth::kFalse) continue;
    const GroundAtom atom = vocabulary.Atom(i);
    literal_t& literal = literals.emplace_back();
    literal.predicate =
        vocabulary.predicates()[static_cast<size_t>(atom.predicate)].name;
    for (const int object : atom.objects) {
      literal.arguments.push_back(
          vocabulary.objects()[static_cast<size_t>(object)].name);
    }
    literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
    literal.value =
        truth == Truth::kTrue ? literal_t::TRUE_ : literal_t::UNKNOWN;
  }
  return literals;
}

bool IsActionName(const std::string& name) {
  return !name.empty() && name.size() <= TaskExperience::kMaxName &&
         std::isalpha(static_cast<unsigned char>(name[0])) &&
         std::ranges::all_of(
             name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

/// Reads the parts of an experience; the reason why one cannot be read begins
/// with its place in the message.
class ExperienceReader {
 public:
  explicit ExperienceReader(const Vocabulary& vocabulary)
      : vocabulary_(vocabulary) {}

  Result<std::vector<int>> ToObjects(const std::vector<std::string>& names,
                                     const std::string& where) const {
    std::vector<int> objects;
    for (const std::string& name : names) {
      const auto object = vocabulary_.FindObject(name);
      if (!object) {
        return Reason{fmt::format(
            "{}: the task has no object '{}'{}", where, name,
            NamesInstead(name, NamesIn(vocabulary_.objects(), &Object::name)))};
      }
      objects.push_back(*object);
    }
    return objects;
  }

  Result<State> ToState(const std::vector<literal_t>& literals,
                        const std::string& where) const {
    State state(vocabulary_.num_atoms());
    for (size_t i = 0; i < literals.size(); ++i) {
      const std::string place = fmt::format("{}[{}]", where, i);
      const auto atom = AtomOf(literals[i], place);
      if (!atom) return Reason{atom.reason()};
      if (state.Get(*atom) != Truth::kFalse) {
        return Reason{fmt::format("{}: {} is there twice", place,
                                  vocabulary_.AtomName(*atom))};
      }
      const int8_t value = literals[i].value;
      if (value != literal_t::TRUE_ && value != literal_t::UNKNOWN) {
        return Reason{fmt::format(
            "{}: {} has the value {}; those that are true ({}) or unknown ({}) "
            "are listed, and no others",
            place, vocabulary_.AtomName(*atom), int{value},
            int{literal_t::TRUE_}, int{literal_t::UNKNOWN})};
      }
      state.Set(*atom,
                value == literal_t::TRUE_ ? Truth::kTrue : Truth::kUnknown);
    }
    return state;
  }

 private:
  Result<int> AtomOf(const literal_t& literal, const std::string& place) const {
    const auto predicate = vocabulary_.FindPredicate(literal.predicate);
    if (!predicate) {
      return Reason{fmt::format(
          "{}: the task has no predicate '{}'{}", place, literal.predicate,
          NamesInstead(literal.predicate,
                       NamesIn(vocabulary_.predicates(), &Predicate::name)))};
    }
    const auto& types =
        vocabulary_.predicates()[static_cast<size_t>(*predicate)]
            .argument_types;
    if (literal.arguments.size() != types.size()) {
      return Reason{fmt::format("{}: {} takes {} objects, not {}", place,
                                literal.predicate, types.size(),
                                literal.arguments.size())};
    }
    const auto objects = ToObjects(literal.arguments, place);
    if (!objects) return Reason{objects.reason()};
    const auto atom = vocabulary_.AtomIndex(*predicate, *objects);
    if (!atom) {
      std::vector<std::string> names;
      for (const int type : types) {
        names.push_back(vocabulary_.types().name(type));
      }
      return Reason{fmt::format("{}: {} should be of {}", place,
                                vocabulary_.Show(literal.predicate, *objects),
                                fmt::join(names, ", "))};
    }
    return *atom;
  }

  const Vocabulary& vocabulary_;
};

}  // namespace

Result<TaskExperience> FromMessage(const experience_t& message,
                                   const Vocabulary& vocabulary) {
  if (!IsActionName(message.action)) {
    return Reason{fmt::format(
        "action: should be a letter, then letters, digits and _, at most {} in "
        "all",
        TaskExperience::kMaxName)};
  }
  if (message.arguments.size() > TaskExperience::kMaxObjects) {
    return Reason{
        fmt::format("arguments: {} are too many; at most {} are taken",
                    message.arguments.size(), TaskExperience::kMaxObjects)};
  }
  if (message.agent != kPersonWord && message.agent != kRobotWord) {
    return Reason{fmt::format("agent: should be {} or {}, not '{}'",
                              kPersonWord, kRobotWord, message.agent)};
  }
  const ExperienceReader reader(vocabulary);
  auto objects = reader.ToObjects(message.arguments, "arguments");
  if (!objects) return Reason{objects.reason()};
  auto before = reader.ToState(message.before, "before");
  if (!before) return Reason{before.reason()};
  auto after = reader.ToState(message.after, "after");
  if (!after) return Reason{after.reason()};
  return TaskExperience{
      message.action, *std::move(objects),
      message.agent == kRobotWord ? Agent::kRobot : Agent::kPerson,
      *std::move(before), *std::move(after)};
}

experience_t ToMessage(const TaskExperience& experience,
                       const Vocabulary& vocabulary) {
  experience_t message{};
  message.action = experience.action;
  for (const int object : experience.objects) {
    message.arguments.push_back(
        vocabulary.objects()[static_cast<size_t>(object)].name);
  }
  message.num_arguments = static_cast<int32_t>(message.arguments.size());
  message.agent = experience.agent == Agent::kRobot ? kRobotWord : kPersonWord;
  message.before = LiteralsOf(experience.before, vocabulary);
  message.num_before = static_cast<int32_t>(message.before.size());
  message.after = LiteralsOf(experience.after, vocabulary);
  message.num_after = static_cast<int32_t>(message.after.size());
  return message;
}

}  // namespace cell
