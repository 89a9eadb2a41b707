#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/planning/alternatives.h"
#include "common/planning/ground_ppddl.h"
#include "common/planning/ppddl_bindings.h"

namespace cell::planning {

/// What exceeds the limits of grounding; GroundPpddl() makes a reason of it.
struct TooLarge {
  std::string text;
};

inline constexpr const char* kNarrower =
    "give parameters narrower types or static conditions";

/// Grounds the conditions of a world and numbers the atoms that occur in them.
/// Functions throw TooLarge.
class PpddlConditions {
 public:
  PpddlConditions(const PpddlWorld& world, const GroundingLimits& limits)
      : world_(world), limits_(limits) {}

  /// Names in errors what is grounded from now on.
  void Begin(const std::string& where);
  const std::string& where() const { return where_; }

  /// The conditions by which `condition` has the value.
  Alternatives Normalize(const ppddl::Condition& condition, bool value,
                         const Objects& binding);
  /// The number of an atom; nullopt if an object is of a wrong type: then it is
  /// never true.
  std::optional<int> AtomOf(int predicate,
                            const std::vector<ppddl::Term>& terms,
                            const Objects& binding);
  /// To be called for each quantifier before its instances are visited.
  void CountInstances(const std::vector<ppddl::Variable>& variables);

  /// The atoms met so far, and their truth at first.
  const std::vector<GroundAtom>& atoms() const { return atoms_; }
  const std::vector<bool>& initial() const { return initial_; }

 private:
  int Intern(const ppddl::GroundAtom& atom);
  Alternatives NormalizeAtom(const ppddl::Condition& condition, bool value,
                             const Objects& binding);
  std::vector<Alternatives> PartsOf(const ppddl::Condition& condition,
                                    bool value, const Objects& binding);
  std::vector<Alternatives> InstancesOf(const ppddl::Condition& condition,
                                        bool value, const Objects& binding);
  /// All of the parts, or one of them.
  Alternatives Join(bool all, const std::vector<Alternatives>& parts) const;
  void CheckSize(const Alternatives& alternatives) const;

  const PpddlWorld& world_;
  GroundingLimits limits_;
  std::vector<GroundAtom> atoms_;
  std::vector<bool> initial_;
  std::map<ppddl::GroundAtom, int> index_of_;
  std::string where_;
  double num_instances_ = 0;  // of quantifiers since Begin()
};

}  // namespace cell::planning
