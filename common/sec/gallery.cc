#include "common/sec/gallery.h"

#include <algorithm>

namespace cell {

Gallery::Gallery(const Domain& domain, const PartTable& parts)
    : domain_(domain), parts_(parts) {
  for (size_t i = 0; i < domain_.actions().size(); ++i) {
    const Action& action = domain_.actions()[i];
    if (action.sec) entries_.push_back(Read(action, static_cast<int>(i)));
  }
}

GalleryEntry Gallery::Read(const Action& action, int index) const {
  const Config& config = action.sec.value();
  const Moment::Role moved = ReadRole(config["moved"], action);
  if (!std::holds_alternative<size_t>(moved)) {
    config["moved"].Fail("must be an argument of " + action.name);
  }
  return {index, std::get<size_t>(moved), ReadMoment(config["pick"], action),
          ReadMoment(config["place"], action)};
}

Moment Gallery::ReadMoment(const Config& config, const Action& action) const {
  Moment moment;
  if (config.Has("touch")) moment.touch = ReadPairs(config["touch"], action);
  if (config.Has("apart")) moment.apart = ReadPairs(config["apart"], action);
  if (config.Has("where")) {
    moment.where =
        ParseLiterals(config["where"], domain_.vocabulary(), action.arguments);
  }
  return moment;
}

std::vector<Moment::Pair> Gallery::ReadPairs(const Config& config,
                                             const Action& action) const {
  std::vector<Moment::Pair> pairs;
  for (const Config& item : config.Items()) {
    const std::vector<Config> names = item.Items();
    if (names.size() != 2) item.Fail("needs two names");
    pairs.push_back({ReadRole(names[0], action), ReadRole(names[1], action)});
  }
  return pairs;
}

Moment::Role Gallery::ReadRole(const Config& config,
                               const Action& action) const {
  const auto name = config.As<std::string>();
  for (size_t i = 0; i < action.arguments.size(); ++i) {
    if (action.arguments[i].name == name) return i;
  }
  if (name != Cast::kTable && !parts_.Find(name)) {
    config.Fail("'" + name + "' is no argument, part or table");
  }
  return name;
}

std::vector<Binding> Gallery::BindingsFor(const GalleryEntry& entry,
                                          const std::string& part) const {
  const Vocabulary& vocabulary = domain_.vocabulary();
  const auto moved = vocabulary.FindObject(part);
  std::vector<Binding> bindings = {{}};
  const auto& arguments =
      domain_.actions()[static_cast<size_t>(entry.action)].arguments;
  for (size_t i = 0; i < arguments.size(); ++i) {
    std::vector<Binding> longer;
    for (const int object : vocabulary.ObjectsOf(arguments[i].type)) {
      if (i == entry.moved && object != moved) continue;
      for (Binding binding : bindings) {
        binding.push_back(object);
        longer.push_back(std::move(binding));
      }
    }
    bindings = std::move(longer);
  }
  std::erase_if(bindings, [&](const Binding& binding) {
    return !StaticsAgree(entry.pick, binding) ||
           !StaticsAgree(entry.place, binding);
  });
  return bindings;
}

bool Gallery::MayBe(const Moment& moment, const Binding& binding,
                    const SensedFrame& frame) const {
  return TouchesAgree(moment, binding, frame.frame.relations) &&
         MayHold(moment.where, binding, frame.state, domain_.vocabulary());
}

bool Gallery::MustBe(const Moment& moment, const Binding& binding,
                     const SensedFrame& frame) const {
  return TouchesAgree(moment, binding, frame.frame.relations) &&
         std::all_of(moment.where.begin(), moment.where.end(),
                     [&](const Literal& literal) {
                       return MustHold(literal, binding, frame.state,
                                       domain_.vocabulary());
                     });
}

bool Gallery::TouchesAgree(const Moment& moment, const Binding& binding,
                           const TouchGraph& graph) const {
  const auto touch = [&](const Moment::Pair& pair) {
    return Touch(graph, NameOf(pair[0], binding), NameOf(pair[1], binding));
  };
  return std::all_of(moment.touch.begin(), moment.touch.end(), touch) &&
         std::none_of(moment.apart.begin(), moment.apart.end(), touch);
}

bool Gallery::StaticsAgree(const Moment& moment, const Binding& binding) const {
  const State nothing(domain_.vocabulary().num_atoms());
  return std::all_of(
      moment.where.begin(), moment.where.end(), [&](const Literal& literal) {
        return !literal.is_static ||
               MustHold(literal, binding, nothing, domain_.vocabulary());
      });
}

std::string Gallery::NameOf(const Moment::Role& role,
                            const Binding& binding) const {
  if (const auto* name = std::get_if<std::string>(&role)) return *name;
  const auto object = static_cast<size_t>(binding[std::get<size_t>(role)]);
  const std::string& name = domain_.vocabulary().objects()[object].name;
  const Site* site = parts_.FindSite(name);
  return site ? site->host : name;
}

}  // namespace cell
