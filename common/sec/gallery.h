#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "common/relational/domain.h"
#include "common/relational/state.h"
#include "common/sec/key_frame.h"

namespace cell {

/// A key frame and what is sensed in it.
struct SensedFrame {
  KeyFrame frame;
  State state;
};

/// What a gallery entry says of the scene at one moment; what it does not
/// mention does not matter.
struct Moment {
  /// Place of an argument in the action, or the name of an object.
  using Role = std::variant<size_t, std::string>;
  using Pair = std::array<Role, 2>;

  std::vector<Pair> touch;     ///< pairs that touch
  std::vector<Pair> apart;     ///< pairs that do not
  std::vector<Literal> where;  ///< what is true
};

/// The characteristic pair of key frames of an action (section VII-A).
struct GalleryEntry {
  int action = 0;    ///< of the domain
  size_t moved = 0;  ///< which argument is picked up and placed
  Moment pick;       ///< before the hand comes
  Moment place;      ///< after the hand has left
};

/// The actions that can be recognised: the `sec` blocks of a domain.
///
///   sec:
///     moved: X
///     pick:  {where: [not Inside(X, Y)], touch: [[X, table]]}
///     place: {where: ["Inside(X, Y)"], apart: [[X, table]]}
///
/// In touch and apart a site stands for the part that has it.
class Gallery {
 public:
  /// @throws ConfigError naming file:key.
  Gallery(const Domain& domain, const PartTable& parts);

  const std::vector<GalleryEntry>& entries() const { return entries_; }
  /// Of an action that has a `sec` block; it need not be the domain's.
  /// @throws ConfigError naming file:key.
  GalleryEntry Read(const Action& action, int index) const;
  const Domain& domain() const { return domain_; }

  /// All bindings of the entry's arguments in which the moved one is `part`,
  /// as far as types and static relations allow them.
  std::vector<Binding> BindingsFor(const GalleryEntry& entry,
                                   const std::string& part) const;

  /// False if the frame contradicts the moment.
  bool MayBe(const Moment& moment, const Binding& binding,
             const SensedFrame& frame) const;
  /// True if the frame leaves no doubt of it.
  bool MustBe(const Moment& moment, const Binding& binding,
              const SensedFrame& frame) const;

 private:
  Moment ReadMoment(const Config& config, const Action& action) const;
  std::vector<Moment::Pair> ReadPairs(const Config& config,
                                      const Action& action) const;
  Moment::Role ReadRole(const Config& config, const Action& action) const;
  bool TouchesAgree(const Moment& moment, const Binding& binding,
                    const TouchGraph& graph) const;
  bool StaticsAgree(const Moment& moment, const Binding& binding) const;
  std::string NameOf(const Moment::Role& role, const Binding& binding) const;

  Domain domain_;
  PartTable parts_;
  std::vector<GalleryEntry> entries_;
};

}  // namespace cell
