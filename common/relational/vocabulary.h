#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "common/config/config.h"
#include "common/parts/part_table.h"
#include "common/relational/type_hierarchy.h"

namespace cell {

/// An argument of literals: a part, a site of a part, or a constant.
struct Object {
  std::string name;
  int type;
};

/// A relation that the world may change (section V-C).
struct Predicate {
  /// What an arm reports of itself, since geometry cannot decide it.
  enum class Report {
    kHeld,      ///< (part, arm): it is in the arm's gripper
    kReachable  ///< (arm, part): the arm could take it, or holds it
  };
  std::string name;
  std::vector<int> argument_types;
  std::optional<Report> report;  ///< nothing: it is sensed
};

/// A relation that never changes: listed, or taken from the part table. Each
/// type is one too, with one argument.
struct StaticRelation {
  std::string name;
  std::vector<int> argument_types;
  std::set<std::vector<int>> facts;  ///< objects
};

/// A predicate of certain objects.
struct GroundAtom {
  int predicate;
  std::vector<int> objects;
  bool operator==(const GroundAtom&) const = default;
};

/// The words of a domain: types, objects, predicates, static relations. All of
/// them are indices; objects, predicates and ground atoms are in the order of
/// their names, so that index order is message order.
class Vocabulary {
 public:
  /// Reads `types`, `constants` (optional: name to type), `static_facts`
  /// (optional) and `predicates` of a domain, but for their `geometry` (see
  /// ReadGeometries()); objects are the parts of `parts` and their sites
  /// besides.
  /// @throws ConfigError naming file:key for unknown types and duplicate names.
  static Vocabulary FromConfig(const Config& domain, const PartTable& parts);

  const TypeHierarchy& types() const { return types_; }
  const std::vector<Object>& objects() const { return objects_; }
  const std::vector<Predicate>& predicates() const { return predicates_; }
  const std::vector<StaticRelation>& static_relations() const {
    return static_relations_;
  }
  std::optional<int> FindObject(const std::string& name) const;
  std::optional<int> FindPredicate(const std::string& name) const;
  std::optional<int> FindStatic(const std::string& name) const;
  bool IsOf(int object, int type) const {
    return types_.IsA(objects_[object].type, type);
  }
  /// In ascending order.
  const std::vector<int>& ObjectsOf(int type) const {
    return objects_of_type_.at(type);
  }

  int num_atoms() const { return num_atoms_; }
  /// The index of a ground atom; nothing if an object is not of the
  /// predicate's argument type.
  /// @throws std::invalid_argument for a wrong number of objects.
  std::optional<int> AtomIndex(int predicate,
                               std::span<const int> objects) const;
  GroundAtom Atom(int index) const;
  /// "Clear(bolt_1)"
  std::string AtomName(int index) const;
  /// "Name(a, b)"
  std::string Show(const std::string& name, std::span<const int> objects) const;

 private:
  void AddObjects(const Config& domain, const PartTable& parts);
  void AddStatics(const Config& domain, const PartTable& parts);
  void AddPredicates(const Config& domain);
  Predicate LoadPredicate(const std::string& name, const Config& config) const;
  void AddStaticsOfTypes();
  int TypeOf(const std::string& name, const Config& config) const;
  std::vector<int> TypesOf(const Config& names) const;
  void CheckIsNew(const std::string& name, const Config& config) const;
  std::set<std::vector<int>> ListedFacts(const Config& config,
                                         const std::vector<int>& types) const;
  std::set<std::vector<int>> FactsOfParts(const Config& source,
                                          const PartTable& parts) const;

  TypeHierarchy types_;
  std::vector<Object> objects_;
  std::vector<std::vector<int>> objects_of_type_;
  std::vector<std::vector<int>> position_in_type_;  // [type][object], or -1
  std::vector<Predicate> predicates_;
  std::vector<StaticRelation> static_relations_;
  std::vector<int> first_atom_;  // of each predicate
  int num_atoms_ = 0;
};

}  // namespace cell
