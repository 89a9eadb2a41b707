#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "common/geometry/part_shape.h"
#include "common/parts/part_table.h"
#include "common/predicates/predicate_geometry.h"
#include "common/relational/state.h"
#include "common/relational/vocabulary.h"
#include "common/scene/scene.h"

namespace cell {

/// Senses every ground predicate of a domain in a scene, by the geometry that
/// the domain gives them: a function of that scene alone, without memory
/// (section VII-B). A part that a hand carries - held, and not seated anywhere
/// - blocks no site. What depends on a part that is not tracked is unknown, and
/// so is what arms report, and whether a part is seated or tilted if that lies
/// within the poses' uncertainty.
class PredicateSensor {
 public:
  /// @pre one of `geometries` for each predicate of the vocabulary.
  PredicateSensor(const Vocabulary& vocabulary, const PartTable& parts,
                  const Eigen::AlignedBox3d& workspace,
                  std::vector<PredicateGeometry> geometries,
                  const PoseUncertainty& uncertainty = {});
  PredicateSensor(const PredicateSensor&) = delete;  // points into itself
  PredicateSensor& operator=(const PredicateSensor&) = delete;

  /// @pre the scene has all parts of the table.
  State Sense(const Scene& scene) const;

 private:
  /// A scene, and which of its parts are seated somewhere.
  struct View {
    const Scene& scene;
    std::vector<bool> is_seated;

    bool IsCarried(size_t part) const {
      return scene.items[part].is_held && !is_seated[part];
    }
  };

  Truth SenseAtom(const GroundAtom& atom, const View& view) const;
  /// One for each kind of geometry.
  template <class Geometry>
  Truth SenseKind(const Geometry& geometry, const GroundAtom& atom,
                  const View& view) const;
  /// Parts that lie over `part`: all of them are higher than its middle.
  std::vector<size_t> PartsOver(size_t part, const View& view) const;
  bool CoversGrasps(size_t cover, size_t part,
                    const GraspableGeometry& graspable, const View& view) const;
  bool IsWithinReach(size_t part, const View& view) const;

  size_t PartOf(int object) const { return part_of_object_[Index(object)]; }
  const Site& SiteOf(int object) const {
    return *site_of_object_[Index(object)];
  }
  static size_t Index(int index) { return static_cast<size_t>(index); }
  size_t IndexOfPart(const std::string& name) const;

  Vocabulary vocabulary_;
  PartTable parts_;
  Eigen::AlignedBox3d workspace_;
  std::vector<PartShape> shapes_;
  std::vector<size_t> part_of_object_;         // of parts
  std::vector<const Site*> site_of_object_;    // of sites
  std::vector<PredicateGeometry> geometries_;  // of each predicate
  PoseUncertainty uncertainty_;
};

}  // namespace cell
