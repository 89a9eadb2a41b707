#include "common/parts/part_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "common/parts/piece_config.h"

namespace cell {
namespace {

using Eigen::Vector3d;

constexpr double kDeg = std::numbers::pi / 180;
constexpr double kMaxLength = 10'000;  // [mm]

double Length(const Config& config, const std::string& key) {
  return kMm * config.Number(key, 0, kMaxLength);
}

/// xyz [mm] and roll, pitch, yaw [deg] about the fixed axes.
Eigen::Isometry3d Pose(const Config& config) {
  const std::vector<double> xyz = config.Numbers("xyz", 3);
  const std::vector<double> rpy = config.Has("rpy")
                                      ? config.Numbers("rpy", 3)
                                      : std::vector<double>{0, 0, 0};
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = kMm * Vector3d(xyz[0], xyz[1], xyz[2]);
  X.linear() = (Eigen::AngleAxisd(kDeg * rpy[2], Vector3d::UnitZ()) *
                Eigen::AngleAxisd(kDeg * rpy[1], Vector3d::UnitY()) *
                Eigen::AngleAxisd(kDeg * rpy[0], Vector3d::UnitX()))
                   .toRotationMatrix();
  return X;
}

Site SiteFromConfig(const Config& config, const std::string& host) {
  Site site;
  site.name = host + "." + config.Get<std::string>("name");
  site.type = config.Get<std::string>("type");
  site.host = host;
  site.X_HS = Pose(config);
  site.approach = Length(config, "approach");
  site.opening = Length(config, "opening");
  site.depth = Length(config, "depth");
  return site;
}

Thread ThreadFromConfig(const Config& config) {
  Thread thread;
  thread.site_type = config.Get<std::string>("site_type");
  thread.pitch = kMm * config.Number("pitch", 0.1, kMaxLength);
  thread.engagement = Length(config, "engagement");
  thread.max_offset = Length(config, "max_offset");
  thread.max_tilt = kDeg * config.Number("max_tilt", 0, 90);
  return thread;
}

Grasp GraspFromConfig(const Config& config) {
  Grasp grasp;
  grasp.X_OG = Pose(config);
  grasp.width = Length(config, "width");
  if (config.Has("grips")) {
    grasp.grips = config.Get<std::vector<std::string>>("grips");
    if (grasp.grips.empty()) config["grips"].Fail("names no grip");
  }
  return grasp;
}

std::array<double, 3> Colour(const Config& config) {
  const std::vector<double> rgb = config.Numbers("colour", 3);
  for (const double c : rgb) {
    if (!(c >= 0 && c <= 1)) config["colour"].Fail("lies outside [0, 1]");
  }
  return {rgb[0], rgb[1], rgb[2]};
}

Part PartFromConfig(const Config& config, const std::string& name) {
  Part part;
  part.name = name;
  part.type = config.Get<std::string>("type");
  for (const Config& fit : config.ItemsOf("fits")) {
    part.fits.push_back(fit.As<std::string>());
    if (std::count(part.fits.begin(), part.fits.end(), part.fits.back()) > 1) {
      fit.Fail("'" + part.fits.back() + "' is named twice");
    }
  }
  part.symmetry_order = config.Integer("symmetry_order", 0, 360);
  part.is_fixed = config.GetOr("fixed", false);
  part.density = config.Number("density", 1, 25'000);
  part.colour = Colour(config);
  for (const Config& entry : config["pieces"].Items()) {
    for (Piece& piece : PiecesFromConfig(entry)) {
      part.pieces.push_back(std::move(piece));
    }
  }
  if (!(MomentsOf(part.pieces).volume > 0)) {
    config["pieces"].Fail("have no volume");
  }
  for (const Config& site : config.ItemsOf("sites")) {
    part.sites.push_back(SiteFromConfig(site, name));
  }
  for (const Config& grasp : config.ItemsOf("grasps")) {
    part.grasps.push_back(GraspFromConfig(grasp));
  }
  return part;
}

/// Names across parts: sites are unique, contact classes and the types that
/// something fits are known.
void CheckReferences(const Config& config, const PartTable& table) {
  std::set<std::string> classes, site_types, sites;
  for (const auto& [first, second] : table.contacts()) {
    classes.insert({first, second});
  }
  for (const Part& part : table.parts()) {
    for (const Site& site : part.sites) {
      site_types.insert(site.type);
      if (!sites.insert(site.name).second) {
        config["parts"][part.name]["sites"].Fail("two are named " + site.name);
      }
    }
  }
  for (const Part& part : table.parts()) {
    const Config entry = config["parts"][part.name];
    for (const std::string& fit : part.fits) {
      if (!site_types.contains(fit)) {
        entry["fits"].Fail("no site is of type '" + fit + "'");
      }
    }
    for (const Piece& piece : part.pieces) {
      const std::string& name = piece.contact_class;
      if (!name.empty() && !classes.contains(name)) {
        entry["pieces"].Fail("contact class '" + name +
                             "' does not appear in contacts");
      }
    }
  }
  for (const Thread& thread : table.threads()) {
    if (!site_types.contains(thread.site_type)) {
      config["threads"].Fail("no site is of type '" + thread.site_type + "'");
    }
  }
}

template <class T>
const T* FindNamed(const std::vector<T>& items, const std::string& name) {
  for (const T& item : items) {
    if (item.name == name) return &item;
  }
  return nullptr;
}

}  // namespace

PartTable PartTable::FromConfig(const Config& config) {
  PartTable table;
  if (config.Has("parameters")) {  // values that anchors refer to
    for (const auto& [name, value] : config["parameters"].Entries()) {
      value.As<double>();
    }
  }
  for (const Config& pair : config["contacts"].Items()) {
    const auto names = pair.As<std::vector<std::string>>();
    if (names.size() != 2) pair.Fail("needs two contact classes");
    table.contacts_.push_back({names[0], names[1]});
  }
  for (const auto& [name, entry] : config["parts"].Entries()) {
    if (table.Find(name) != nullptr || name == "table") {
      entry.Fail("the name '" + name + "' is taken");
    }
    table.parts_.push_back(PartFromConfig(entry, name));
  }
  if (table.parts_.empty()) config["parts"].Fail("names no part");
  for (const Config& thread : config.ItemsOf("threads")) {
    const Thread next = ThreadFromConfig(thread);
    if (table.FindThread(next.site_type) != nullptr) {
      thread["site_type"].Fail("'" + next.site_type + "' has a thread already");
    }
    table.threads_.push_back(next);
  }
  CheckReferences(config, table);
  config.Finish();
  return table;
}

const Part* PartTable::Find(const std::string& name) const {
  return FindNamed(parts_, name);
}

const Site* PartTable::FindSite(const std::string& name) const {
  for (const Part& part : parts_) {
    if (const Site* site = FindNamed(part.sites, name)) return site;
  }
  return nullptr;
}

const Thread* PartTable::FindThread(const std::string& site_type) const {
  for (const Thread& thread : threads_) {
    if (thread.site_type == site_type) return &thread;
  }
  return nullptr;
}

}  // namespace cell
