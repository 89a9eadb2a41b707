#include "common/parts/part_table.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "common/geometry/degree.h"
#include "common/parts/piece_config.h"

namespace cell {
namespace {

using Eigen::Vector3d;

constexpr double kLeastLever = 0.005;  // [m] of a handle

double Length(const Config& config, const std::string& key) {
  return kMm * config.Number(key, 0, kMaxLength);
}

Site SiteFromConfig(const Config& config, const std::string& host) {
  Site site;
  site.name = host + "." + config.Get<std::string>("name");
  site.type = config.Get<std::string>("type");
  site.host = host;
  site.X_HS = PoseInMm(config);
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
  thread.max_tilt = kDegree * config.Number("max_tilt", 0, 90);
  return thread;
}

Grasp GraspFromConfig(const Config& config) {
  Grasp grasp;
  grasp.X_OG = PoseInMm(config);
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

/// Of an articulated part: it is gripped by its handle alone.
void ReadJoint(const Config& config, Part* part) {
  if (part->is_fixed) {
    config["joint"].Fail("a fixed part has no joint");
  }
  part->joint = PartJoint::FromConfig(config["joint"]);
  if (!config.Has("handle")) {
    config.Fail(
        "an articulated part needs a handle: {xyz, rpy, width}, where to grip");
  }
  part->grasps = {GraspFromConfig(config["handle"])};
  const Vector3d p_OG = part->grasps.front().X_OG.translation();
  if (!(part->joint->LeverAt(p_OG) > kLeastLever)) {
    config["handle"].Fail("lies on the axis of the hinge");
  }
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
  if (config.Has("joint")) {
    ReadJoint(config, &part);
    return part;
  }
  for (const Config& grasp : config.ItemsOf("grasps")) {
    part.grasps.push_back(GraspFromConfig(grasp));
  }
  return part;
}

/// The host of an articulated part stands still.
void CheckJoint(const Config& config, const Part& part,
                const PartTable& table) {
  const Part* host = table.Find(part.joint->host);
  if (host != nullptr && host->is_fixed) return;
  std::string fixed;
  for (const Part& other : table.parts()) {
    if (other.is_fixed) fixed += (fixed.empty() ? "" : ", ") + other.name;
  }
  config["on"].Fail("'" + part.joint->host +
                    "' is not a fixed part; fixed parts" +
                    (fixed.empty() ? ": none" : ": " + fixed));
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
    if (part.joint) CheckJoint(entry["joint"], part, table);
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
