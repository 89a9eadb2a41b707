#include "common/experiences/experience_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/rules/data_text.h"
#include "common/rules/rule_error.h"
#include "common/text/nearest.h"

namespace cell {
namespace {

/// Of the first line that holds the words; from 1.
int LineOf(const std::string& words, const std::string& text) {
  const size_t at = std::min(text.find(words), text.size());
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

/// What never changes is left out, but for the type of every object that is no
/// constant: a state has to mention the objects of the action that follows.
rules::WorldState WithoutStaticFacts(rules::WorldState state,
                                     const RuleWorld& world) {
  const rules::World& w = *world.world();
  const Vocabulary& vocabulary = world.vocabulary();
  for (const StaticRelation& relation : vocabulary.static_relations()) {
    const int symbol = *w.symbols().Find(relation.name);
    for (int i = 0; i < w.num_places(symbol); ++i) {
      rules::World::Set(&state, w.first(symbol) + i, false);
    }
  }
  for (int i = w.num_constants(); i < w.num_objects(); ++i) {
    const Object& object =
        vocabulary.objects()[static_cast<size_t>(world.ObjectOf(i))];
    const int symbol = *w.symbols().Find(vocabulary.types().name(object.type));
    rules::World::Set(&state, w.PlaceOf(symbol, std::vector{i}), true);
  }
  return state;
}

/// Translates from the objects of a text to those of the task.
class TextReader {
 public:
  TextReader(const std::string& text, const std::string& file,
             const RuleWorld& world, const rules::World& from)
      : text_(text), file_(file), world_(world), from_(from) {
    for (const std::string& name : from.objects()) {
      const auto object = world.vocabulary().FindObject(name);
      if (!object) {
        const auto& objects = world.vocabulary().objects();
        Fail(name,
             fmt::format("the task has no object '{}'{}", name,
                         NamesInstead(name, NamesIn(objects, &Object::name))));
      }
      objects_.push_back(*object);
    }
  }

  GroundAction ToAction(const rules::GroundAct& act) const {
    GroundAction action{world_.ActionOf(act.action), {}};
    const Action& lifted = world_.actions()[static_cast<size_t>(action.action)];
    for (size_t i = 0; i < act.arguments.size(); ++i) {
      const int object = objects_[static_cast<size_t>(act.arguments[i])];
      if (!world_.vocabulary().IsOf(object, lifted.arguments[i].type)) {
        FailType(act.action, act.arguments, i, lifted.arguments[i].type);
      }
      action.arguments.push_back(object);
    }
    return action;
  }

  State ToState(const rules::WorldState& state) const {
    const Vocabulary& vocabulary = world_.vocabulary();
    State result(vocabulary.num_atoms());
    for (size_t p = 0; p < vocabulary.predicates().size(); ++p) {
      const auto symbol = from_.symbols().Find(vocabulary.predicates()[p].name);
      if (!symbol) continue;
      for (int i = 0; i < from_.num_places(*symbol); ++i) {
        const int place = from_.first(*symbol) + i;
        if (rules::World::Get(state, place)) {
          result.Set(AtomAt(static_cast<int>(p), *symbol, place), Truth::kTrue);
        }
      }
    }
    return result;
  }

 private:
  int AtomAt(int predicate, int symbol, int place) const {
    const std::vector<int> there = from_.ObjectsAt(symbol, place);
    const auto& types = world_.vocabulary()
                            .predicates()[static_cast<size_t>(predicate)]
                            .argument_types;
    std::vector<int> objects;
    for (size_t i = 0; i < there.size(); ++i) {
      objects.push_back(objects_[static_cast<size_t>(there[i])]);
      if (!world_.vocabulary().IsOf(objects.back(), types[i])) {
        FailType(symbol, there, i, types[i]);
      }
    }
    return *world_.vocabulary().AtomIndex(predicate, objects);
  }

  [[noreturn]] void FailType(int symbol, const std::vector<int>& objects,
                             size_t argument, int type) const {
    const std::string name =
        from_.objects()[static_cast<size_t>(objects[argument])];
    Fail(from_.Show(symbol, objects),
         fmt::format("{}: '{}' is not a {}", from_.Show(symbol, objects), name,
                     world_.vocabulary().types().name(type)));
  }

  [[noreturn]] void Fail(const std::string& words,
                         const std::string& message) const {
    throw rules::RuleError(file_, LineOf(words, text_), message);
  }

  const std::string& text_;
  const std::string& file_;
  const RuleWorld& world_;
  const rules::World& from_;
  std::vector<int> objects_;  // the vocabulary's
};

}  // namespace

std::string ToText(std::span<const rules::Experience> experiences,
                   const RuleWorld& world) {
  rules::ExperienceSet set{world.world(), {}};
  for (const rules::Experience& experience : experiences) {
    set.experiences.push_back({WithoutStaticFacts(experience.before, world),
                               experience.act,
                               WithoutStaticFacts(experience.after, world)});
  }
  return rules::ToText(set);
}

std::vector<rules::Experience> ReadExperiences(const std::string& text,
                                               const std::string& file,
                                               const RuleWorld& world) {
  const rules::ExperienceSet set =
      rules::ParseExperiences(text, file, world.world()->shared_symbols());
  const TextReader reader(text, file, world, *set.world);
  std::vector<rules::Experience> experiences;
  for (const rules::Experience& experience : set.experiences) {
    experiences.push_back(world.ToExperience(reader.ToState(experience.before),
                                             reader.ToAction(experience.act),
                                             reader.ToState(experience.after)));
  }
  return experiences;
}

}  // namespace cell
