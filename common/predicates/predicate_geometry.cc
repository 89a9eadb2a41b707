#include "common/predicates/predicate_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>

namespace cell {
namespace {

class Reader {
 public:
  Reader(const Predicate& predicate, const Vocabulary& vocabulary,
         const PartTable& parts, const std::vector<PartShape>& shapes,
         const Config& config)
      : predicate_(predicate),
        vocabulary_(vocabulary),
        parts_(parts),
        shapes_(shapes),
        config_(config) {}

  PredicateGeometry Read() const {
    if (config_.Entries().size() == 1) {
      if (config_.Has("seated")) return ReadSeated(config_["seated"]);
      if (config_.Has("tilted")) return ReadTilted(config_["tilted"]);
      if (config_.Has("graspable")) return ReadGraspable(config_["graspable"]);
      if (config_.Has("free_space")) return ReadSpace(config_["free_space"]);
    }
    config_.Fail("needs one of seated, tilted, graspable, free_space");
  }

 private:
  SeatedGeometry ReadSeated(const Config& config) const {
    const bool has_site = config.Has("site");
    CheckCount(has_site ? 1 : 2);
    CheckParts(0);
    SeatedGeometry seated{SeatTolerance::FromConfig(config)};
    const auto touch = config.GetOr<std::string>("touch", "host");
    if (touch != "host" && touch != "any") {
      config["touch"].Fail("must be host or any, not '" + touch + "'");
    }
    seated.must_touch_host = touch == "host";
    if (has_site) {
      const Site* site = parts_.FindSite(config.Get<std::string>("site"));
      if (site == nullptr) config["site"].Fail("no part has this site");
      seated.site = *site;
    } else {
      CheckSites(1);
    }
    return seated;
  }

  TiltedGeometry ReadTilted(const Config& config) const {
    CheckCount(1);
    CheckParts(0);
    return {config.Number("over_deg", 0, 90) * std::numbers::pi / 180};
  }

  GraspableGeometry ReadGraspable(const Config& config) const {
    CheckCount(1);
    CheckParts(0);
    const double finger = config.Number("finger_mm", 0.1, 1000) * 1e-3;
    const double above = config.Number("above_mm", 0.1, 10'000) * 1e-3;
    return {finger, ClearanceColumn(finger, 0, above)};
  }

  FreeSpaceGeometry ReadSpace(const Config& config) const {
    CheckCount(1);
    CheckSites(0);
    const double above = config.Number("above_mm", 0.1, 10'000) * 1e-3;
    FreeSpaceGeometry space;
    for (const int object : ObjectsOf(0)) {
      const Site& site = *parts_.FindSite(Name(object));
      if (!(site.opening > 0)) Fail(site.name + " has no opening");
      const double floor = FloorOf(site);
      space.columns.emplace_back(site.opening, floor,
                                 floor + site.depth + above);
    }
    return space;
  }

  // A site's frame is where the frame of the seated part comes to be, so its
  // floor is where that part ends. Of the parts that fit, the longest counts.
  double FloorOf(const Site& site) const {
    double floor = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < parts_.parts().size(); ++i) {
      const auto& fits = parts_.parts()[i].fits;
      if (std::find(fits.begin(), fits.end(), site.type) == fits.end()) {
        continue;
      }
      floor = std::min(floor, shapes_[i].box().min().z());
    }
    if (floor > 1e9) Fail("no part fits " + site.name);
    return floor;
  }

  void CheckCount(size_t count) const {
    if (predicate_.argument_types.size() != count) {
      Fail(fmt::format("{} has {} arguments, this needs {}", predicate_.name,
                       predicate_.argument_types.size(), count));
    }
  }
  void CheckParts(size_t argument) const {
    for (const int object : ObjectsOf(argument)) {
      if (!parts_.Find(Name(object))) Fail(Name(object) + " is not a part");
    }
  }
  void CheckSites(size_t argument) const {
    for (const int object : ObjectsOf(argument)) {
      if (!parts_.FindSite(Name(object))) Fail(Name(object) + " is not a site");
    }
  }
  const std::vector<int>& ObjectsOf(size_t argument) const {
    return vocabulary_.ObjectsOf(predicate_.argument_types[argument]);
  }
  const std::string& Name(int object) const {
    return vocabulary_.objects()[static_cast<size_t>(object)].name;
  }
  [[noreturn]] void Fail(const std::string& message) const {
    config_.Fail(message);
  }

  const Predicate& predicate_;
  const Vocabulary& vocabulary_;
  const PartTable& parts_;
  const std::vector<PartShape>& shapes_;
  const Config config_;
};

}  // namespace

std::vector<PredicateGeometry> ReadGeometries(const Config& domain,
                                              const Vocabulary& vocabulary,
                                              const PartTable& parts) {
  const std::vector<PartShape> shapes = ShapesOf(parts);
  std::vector<PredicateGeometry> geometries;
  for (const Predicate& predicate : vocabulary.predicates()) {
    if (predicate.report) {
      geometries.emplace_back(ReportedGeometry{});
      continue;
    }
    const Config config = domain["predicates"][predicate.name];
    if (!config.Has("geometry")) config.Fail("needs a geometry");
    geometries.push_back(
        Reader(predicate, vocabulary, parts, shapes, config["geometry"])
            .Read());
  }
  return geometries;
}

}  // namespace cell
