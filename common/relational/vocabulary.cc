#include "common/relational/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace cell {
namespace {

constexpr int kMaxAtoms = 100'000;  // more is a mistake in a domain's types

template <class Named>
std::optional<int> FindByName(const std::vector<Named>& all,
                              const std::string& name) {
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return static_cast<int>(i);
  }
  return std::nullopt;
}

constexpr auto kByName = [](const auto& a, const auto& b) {
  return a.name < b.name;
};

}  // namespace

Vocabulary Vocabulary::FromConfig(const Config& domain,
                                  const PartTable& parts) {
  Vocabulary v;
  v.types_ = TypeHierarchy::FromConfig(domain["types"]);
  v.AddObjects(domain, parts);
  v.AddStaticsOfTypes();
  v.AddStatics(domain, parts);
  v.AddPredicates(domain);
  return v;
}

void Vocabulary::AddObjects(const Config& domain, const PartTable& parts) {
  const Config types = domain["types"];
  const auto add = [&](const std::string& name, const std::string& type,
                       const Config& where) {
    const std::optional<int> t = types_.Find(type);
    if (!t) {
      where.Fail(fmt::format("'{}' is of the type '{}', which is not declared",
                             name, type));
    }
    if (FindObject(name)) where.Fail("two objects are named '" + name + "'");
    objects_.push_back({name, *t});
  };
  for (const Part& part : parts.parts()) {
    add(part.name, part.type, types);
    for (const Site& site : part.sites) add(site.name, site.type, types);
  }
  if (domain.Has("constants")) {
    for (const auto& [name, node] : domain["constants"].Entries()) {
      add(name, node.As<std::string>(), node);
    }
  }
  std::sort(objects_.begin(), objects_.end(), kByName);

  objects_of_type_.resize(types_.size());
  position_in_type_.assign(types_.size(),
                           std::vector<int>(objects_.size(), -1));
  for (int type = 0; type < types_.size(); ++type) {
    for (int o = 0; o < static_cast<int>(objects_.size()); ++o) {
      if (!IsOf(o, type)) continue;
      position_in_type_[type][o] =
          static_cast<int>(objects_of_type_[type].size());
      objects_of_type_[type].push_back(o);
    }
  }
}

void Vocabulary::AddStaticsOfTypes() {
  for (int type = 0; type < types_.size(); ++type) {
    StaticRelation relation{types_.name(type), {TypeHierarchy::kObject}, {}};
    for (const int object : ObjectsOf(type)) relation.facts.insert({object});
    static_relations_.push_back(std::move(relation));
  }
}

void Vocabulary::AddStatics(const Config& domain, const PartTable& parts) {
  if (!domain.Has("static_facts")) return;
  for (const auto& [name, node] : domain["static_facts"].Entries()) {
    CheckIsNew(name, node);
    StaticRelation relation{name, TypesOf(node["arguments"]), {}};
    if (node.Has("of_parts")) {
      if (relation.argument_types.size() != 2) {
        node["arguments"].Fail("facts of parts have two arguments");
      }
      relation.facts = FactsOfParts(node["of_parts"], parts);
    } else {
      relation.facts = ListedFacts(node["facts"], relation.argument_types);
    }
    static_relations_.push_back(std::move(relation));
  }
}

std::set<std::vector<int>> Vocabulary::ListedFacts(
    const Config& config, const std::vector<int>& types) const {
  std::set<std::vector<int>> facts;
  for (const Config& row : config.Items()) {
    std::vector<int> fact;
    for (const auto& name : row.As<std::vector<std::string>>()) {
      const std::optional<int> object = FindObject(name);
      if (!object) row.Fail("there is no object '" + name + "'");
      if (fact.size() < types.size() && !IsOf(*object, types[fact.size()])) {
        row.Fail(fmt::format("'{}' is not a {}", name,
                             types_.name(types[fact.size()])));
      }
      fact.push_back(*object);
    }
    if (fact.size() != types.size()) {
      row.Fail(
          fmt::format("needs {} objects, has {}", types.size(), fact.size()));
    }
    facts.insert(std::move(fact));
  }
  return facts;
}

std::set<std::vector<int>> Vocabulary::FactsOfParts(
    const Config& source, const PartTable& parts) const {
  const auto kind = source.As<std::string>();
  if (kind != "fits" && kind != "host") {
    source.Fail("'" + kind + "' is neither fits (a part may be seated at a " +
                "site) nor host (a part has a site)");
  }
  std::set<std::vector<int>> facts;
  for (const Part& host : parts.parts()) {
    for (const Site& site : host.sites) {
      const int s = *FindObject(site.name);
      if (kind == "host") facts.insert({*FindObject(host.name), s});
      for (const Part& part : parts.parts()) {
        const bool does_fit =
            std::count(part.fits.begin(), part.fits.end(), site.type) > 0;
        if (kind == "fits" && does_fit) {
          facts.insert({*FindObject(part.name), s});
        }
      }
    }
  }
  return facts;
}

void Vocabulary::AddPredicates(const Config& domain) {
  // Sorted before they are made: to assign a Config changes its YAML tree.
  std::map<std::string, Config> entries;
  for (const auto& [name, node] : domain["predicates"].Entries()) {
    if (!entries.emplace(name, node).second) node.Fail("is listed twice");
  }
  for (const auto& [name, node] : entries) {
    CheckIsNew(name, node);
    predicates_.push_back(LoadPredicate(name, node));
  }
  for (const Predicate& predicate : predicates_) {
    first_atom_.push_back(num_atoms_);
    int64_t num = 1;
    for (const int type : predicate.argument_types) {
      num *= static_cast<int64_t>(ObjectsOf(type).size());
      if (num_atoms_ + num > kMaxAtoms) {
        domain["predicates"].Fail(
            fmt::format("'{}' has more than {} ground predicates; use "
                        "narrower argument types",
                        predicate.name, kMaxAtoms));
      }
    }
    num_atoms_ += static_cast<int>(num);
  }
}

Predicate Vocabulary::LoadPredicate(const std::string& name,
                                    const Config& config) const {
  Predicate predicate{name, TypesOf(config["arguments"]), {}};
  if (!config.Has("reported")) return predicate;
  const Config reported = config["reported"];
  const auto kind = reported.As<std::string>();
  if (kind != "held" && kind != "reachable") {
    reported.Fail("'" + kind + "' is neither held nor reachable");
  }
  if (predicate.argument_types.size() != 2) {
    config["arguments"].Fail("a predicate reported by arms has two arguments");
  }
  if (config.Has("geometry")) {
    reported.Fail(
        "a predicate reported by arms is not sensed and has no geometry");
  }
  predicate.report =
      kind == "held" ? Predicate::Report::kHeld : Predicate::Report::kReachable;
  return predicate;
}

void Vocabulary::CheckIsNew(const std::string& name,
                            const Config& config) const {
  if (FindStatic(name) || FindPredicate(name)) {
    config.Fail("a type, predicate or static fact '" + name + "' is there " +
                "already");
  }
}

int Vocabulary::TypeOf(const std::string& name, const Config& config) const {
  const std::optional<int> type = types_.Find(name);
  if (!type) config.Fail("there is no type '" + name + "'");
  return *type;
}

std::vector<int> Vocabulary::TypesOf(const Config& names) const {
  std::vector<int> types;
  for (const auto& name : names.As<std::vector<std::string>>()) {
    types.push_back(TypeOf(name, names));
  }
  return types;
}

std::optional<int> Vocabulary::FindObject(const std::string& name) const {
  return FindByName(objects_, name);
}

std::optional<int> Vocabulary::FindPredicate(const std::string& name) const {
  return FindByName(predicates_, name);
}

std::optional<int> Vocabulary::FindStatic(const std::string& name) const {
  return FindByName(static_relations_, name);
}

std::optional<int> Vocabulary::AtomIndex(int predicate,
                                         std::span<const int> objects) const {
  const std::vector<int>& types = predicates_.at(predicate).argument_types;
  if (objects.size() != types.size()) {
    throw std::invalid_argument(fmt::format("{} takes {} objects, not {}",
                                            predicates_[predicate].name,
                                            types.size(), objects.size()));
  }
  int index = 0;
  for (size_t i = 0; i < types.size(); ++i) {
    const int position = position_in_type_[types[i]].at(objects[i]);
    if (position < 0) return std::nullopt;
    index = index * static_cast<int>(ObjectsOf(types[i]).size()) + position;
  }
  return first_atom_[predicate] + index;
}

GroundAtom Vocabulary::Atom(int index) const {
  if (index < 0 || index >= num_atoms_) {
    throw std::out_of_range(fmt::format("no ground predicate {}", index));
  }
  const auto next =
      std::upper_bound(first_atom_.begin(), first_atom_.end(), index);
  GroundAtom atom{static_cast<int>(next - first_atom_.begin()) - 1, {}};
  const std::vector<int>& types = predicates_[atom.predicate].argument_types;
  int rest = index - first_atom_[atom.predicate];
  atom.objects.resize(types.size());
  for (size_t i = types.size(); i-- > 0;) {
    const std::vector<int>& objects = ObjectsOf(types[i]);
    const int size = static_cast<int>(objects.size());
    atom.objects[i] = objects[rest % size];
    rest /= size;
  }
  return atom;
}

std::string Vocabulary::AtomName(int index) const {
  const GroundAtom atom = Atom(index);
  return Show(predicates_[atom.predicate].name, atom.objects);
}

std::string Vocabulary::Show(const std::string& name,
                             std::span<const int> objects) const {
  std::string text = name + "(";
  for (size_t i = 0; i < objects.size(); ++i) {
    text += (i > 0 ? ", " : "") + objects_.at(objects[i]).name;
  }
  return text + ")";
}

}  // namespace cell
