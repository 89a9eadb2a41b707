#include "services/vtb/world_xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr size_t kMaxClasses = 30;
constexpr double kHandImpedance = 0.95;

std::string Text(const Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

std::string PoseAttributes(const Isometry3d& X) {
  const Quaterniond q(X.linear());
  return fmt::format("pos='{}' quat='{:.17g} {:.17g} {:.17g} {:.17g}'",
                     Text(X.translation()), q.w(), q.x(), q.y(), q.z());
}

/// Each contact class is a bit of the collision masks.
class ContactMasks {
 public:
  explicit ContactMasks(const PartTable& table) {
    for (const auto& [first, second] : table.contacts()) {
      const uint32_t a = BitOf(first), b = BitOf(second);
      partners_[first] |= b;
      partners_[second] |= a;
    }
  }

  std::string Attributes(const std::string& name) {
    return fmt::format("contype='{}' conaffinity='{}'", BitOf(name),
                       partners_[name]);
  }
  /// Of what notices every class and is noticed by none.
  static std::string OfADetector() {
    return fmt::format("contype='0' conaffinity='{}'", 0x7fffffff);
  }

 private:
  uint32_t BitOf(const std::string& name) {
    const auto [it, is_new] = bits_.try_emplace(name, 1u << bits_.size());
    if (is_new && bits_.size() > kMaxClasses) {
      throw std::invalid_argument(
          fmt::format("more than {} contact classes", kMaxClasses));
    }
    return it->second;
  }

  std::map<std::string, uint32_t> bits_;
  std::map<std::string, uint32_t> partners_;
};

class Writer {
 public:
  Writer(const PartTable& table, const CellLayout& layout,
         const PhysicsParams& params)
      : table_(table), layout_(layout), params_(params), masks_(table) {}

  std::string Write() {
    // Bodies first: they name the meshes.
    WriteTable();
    for (const Part& part : table_.parts()) WritePart(part);
    for (const auto& hand : layout_.AllHands()) WriteHand(hand);
    for (const CellLayout::Hand& hand : layout_.hands) {
      for (const Part& part : table_.parts()) {
        WriteGrip(hand.name, part, params_.grip_time_constant, kHandImpedance);
      }
    }
    for (const ArmLayout& arm : layout_.arms) {
      for (const Part& part : table_.parts()) {
        WriteGripperGrip(arm.gripper, part);
      }
    }
    WriteThreads();
    return fmt::format(
        "<mujoco>\n<compiler angle='radian'/>\n"
        // Few contacts share a body: sparse is a third faster.
        "<option timestep='{:.17g}' cone='elliptic' jacobian='sparse'/>\n"
        // An assembly has 110 contacts and 450 rows, no run yet over 125 and
        // 480; parts that a person tries on each other touch at more points.
        // Memory grows with the square of the rows.
        "<size njmax='1000' nconmax='500'/>\n"
        // Contact settings that hold an assembly still (section IV).
        "<default><geom condim='4' friction='{:.17g} 0.005 0.0001'"
        " solref='{:.17g} 1' solimp='0.98 0.995 0.0002'/>"
        "<equality solref='{:.17g} 1'/></default>\n"
        "<asset>\n{}</asset>\n<worldbody>\n{}</worldbody>\n"
        "<equality>\n{}</equality>\n</mujoco>\n",
        params_.dt, params_.friction, std::max(0.004, 2 * params_.dt),
        std::max(0.004, 2 * params_.dt), fmt::to_string(meshes_),
        fmt::to_string(bodies_), fmt::to_string(equalities_));
  }

 private:
  template <class... Args>
  static void Append(fmt::memory_buffer& buffer,
                     fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer), format,
                   std::forward<Args>(args)...);
  }

  void WriteTable() {
    const std::string masks = masks_.Attributes(kTableName);
    Append(bodies_, "<geom name='{}' type='plane' size='2 2 0.1' {}/>\n",
           kTableName, masks);
    const CellLayout::Pedestal& pedestal = layout_.pedestal;
    Append(bodies_,
           "<body name='{}' {}><geom type='box' size='{:.17g} {:.17g} {:.17g}'"
           " pos='0 0 {:.17g}' {}/></body>\n",
           kPedestalName, PoseAttributes(pedestal.X_WP), pedestal.size.x() / 2,
           pedestal.size.y() / 2, pedestal.height / 2, -pedestal.height / 2,
           masks);
  }

  void WritePart(const Part& part) {
    Isometry3d X_WO = Isometry3d::Identity();
    if (!part.is_free()) X_WO = layout_.pedestal.X_WP;
    if (part.joint) X_WO = X_WO * part.joint->X_HO_zero;
    Append(bodies_, "<body name='{}' {}>", part.name, PoseAttributes(X_WO));
    if (part.joint) WriteJoint(*part.joint);
    if (part.is_free()) Append(bodies_, "<freejoint/>");
    if (!part.is_fixed) {
      const VolumeMoments m = MomentsOf(part.pieces);
      const Eigen::Matrix3d I = part.density * m.inertia;
      Append(bodies_,
             "<inertial pos='{}' mass='{:.17g}' fullinertia='"
             "{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}'/>\n",
             Text(m.centre), part.density * m.volume, I(0, 0), I(1, 1), I(2, 2),
             I(0, 1), I(0, 2), I(1, 2));
    }
    for (const Piece& piece : part.pieces) {
      if (!piece.contact_class.empty()) WritePiece(piece);
    }
    Append(bodies_, "</body>\n");
  }

  void WriteJoint(const PartJoint& joint) {
    const bool is_hinge = joint.kind == PartJoint::Kind::kHinge;
    Append(bodies_,
           "<joint type='{}' pos='{}' axis='{}' limited='true'"
           " range='{:.17g} {:.17g}' solreflimit='{:.17g} 1'"
           " solimplimit='0.98 0.995 0.0002'"
           " frictionloss='{:.17g}' damping='{:.17g}'/>",
           is_hinge ? "hinge" : "slide", Text(joint.p_OA), Text(joint.axis),
           joint.lower, joint.upper, std::max(0.004, 2 * params_.dt),
           joint.friction, joint.damping);
  }

  void WritePiece(const Piece& piece) {
    const std::string masks = masks_.Attributes(piece.contact_class);
    switch (piece.kind) {
      case Piece::Kind::kBox:
        Append(bodies_, "<geom type='box' {} size='{}' {}/>\n",
               PoseAttributes(piece.X_OP), Text(piece.half_extents), masks);
        break;
      case Piece::Kind::kCylinder:
        Append(
            bodies_, "<geom type='cylinder' {} size='{:.17g} {:.17g}' {}/>\n",
            PoseAttributes(piece.X_OP), piece.radius, piece.half_length, masks);
        break;
      case Piece::Kind::kHull:
        Append(meshes_, "<mesh name='m{}' vertex='", num_meshes_);
        for (const Vector3d& vertex : piece.vertices) {
          Append(meshes_, "{} ", Text(vertex));
        }
        Append(meshes_, "'/>\n");
        Append(bodies_, "<geom type='mesh' mesh='m{}' {}/>\n", num_meshes_,
               masks);
        ++num_meshes_;
        break;
    }
  }

  void WriteHand(const CellLayout::NamedHand& hand) {
    Append(bodies_, "<body name='{}{}' mocap='true'/>\n", hand.name, kWrist);
    for (const HandType::Box& box : hand.type->boxes) {
      WriteHandBox(hand.name + "." + box.name, box);
    }
  }

  /// A gap beyond any penetration: contacts are found but do not push.
  void WriteHandBox(const std::string& name, const HandType::Box& box) {
    Append(bodies_,
           "<body name='{}' mocap='true'><geom type='box' size='{}' {}"
           " margin='0.001' gap='1'/></body>\n",
           name, Text(box.half_extents), ContactMasks::OfADetector());
  }

  /// A weld of time constant t and impedance d is to a blocked body of mass m
  /// a spring of m / (t^2 d (1 - d)) [N/m] that answers 2 d t [s] ahead. Every
  /// part meets the same spring in a gripper.
  void WriteGripperGrip(const std::string& gripper, const Part& part) {
    const double mass = part.density * MomentsOf(part.pieces).volume;
    const double lead = params_.gripper_lead;
    const double ratio = params_.gripper_stiffness * lead * lead / (4 * mass);
    const double impedance = ratio / (1 + ratio);
    const double time_constant = lead / (2 * impedance);
    WriteGrip(gripper, part, std::max(time_constant, 2 * params_.dt),
              impedance);
  }

  void WriteGrip(const std::string& hand, const Part& part,
                 double time_constant, double impedance) {
    if (part.is_fixed) return;
    Append(equalities_,
           "<weld name='{}' body1='{}{}' body2='{}' active='false'"
           " solref='{:.17g} 1' solimp='{:.17g} {:.17g} 0.001'/>\n",
           GripName(hand, part.name), hand, kWrist, part.name, time_constant,
           impedance, impedance);
  }

  void WriteThreads() {
    for (const Part& host : table_.parts()) {
      for (const Site& site : host.sites) {
        if (table_.FindThread(site.type) == nullptr) continue;
        for (const Part& part : table_.parts()) {
          if (std::ranges::find(part.fits, site.type) == part.fits.end()) {
            continue;
          }
          WriteThread(site, part.name);
        }
      }
    }
  }

  void WriteThread(const Site& site, const std::string& part) {
    for (const int point : {0, 1}) {
      Append(equalities_,
             "<connect name='{}' body1='{}' body2='{}' anchor='0 0 0'"
             " active='false'/>\n",
             ThreadPointName(site.name, part, point), site.host, part);
    }
    Append(equalities_,
           "<weld name='{}' body1='{}' body2='{}' active='false'/>\n",
           ThreadFreezeName(site.name, part), site.host, part);
  }

  const PartTable& table_;
  const CellLayout& layout_;
  const PhysicsParams& params_;
  ContactMasks masks_;
  fmt::memory_buffer meshes_, bodies_, equalities_;
  int num_meshes_ = 0;
};

}  // namespace

std::string GripName(const std::string& hand, const std::string& part) {
  return hand + ":" + part;
}

std::string ThreadPointName(const std::string& site, const std::string& part,
                            int point) {
  return fmt::format("{}:{}:{}", site, part, point);
}

std::string ThreadFreezeName(const std::string& site, const std::string& part) {
  return site + ":" + part;
}

std::string WorldXml(const PartTable& table, const CellLayout& layout,
                     const PhysicsParams& params) {
  return Writer(table, layout, params).Write();
}

}  // namespace cell::vtb
