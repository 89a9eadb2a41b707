#include "common/arms/path_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace cell {
namespace {

// Joints that were reached, each from its parent.
class Tree {
 public:
  void AddRoot(const Joints& q) { nodes_.push_back({q, kNone}); }
  void Add(const Joints& q, size_t parent) { nodes_.push_back({q, parent}); }

  size_t size() const { return nodes_.size(); }
  const Joints& at(size_t node) const { return nodes_[node].q; }

  size_t NearestTo(const Joints& q) const {
    size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < nodes_.size(); ++i) {
      const double square = (nodes_[i].q - q).squaredNorm();
      if (square < least) {
        least = square;
        nearest = i;
      }
    }
    return nearest;
  }

  // From the node to its root.
  std::vector<Joints> WayToRoot(size_t node) const {
    std::vector<Joints> way;
    for (; node != kNone; node = nodes_[node].parent) {
      way.push_back(nodes_[node].q);
    }
    return way;
  }

 private:
  static constexpr size_t kNone = std::numeric_limits<size_t>::max();
  struct Node {
    Joints q;
    size_t parent;
  };
  std::vector<Node> nodes_;
};

class Search {
 public:
  Search(const WhyBlockedAt& why_blocked, const PathPlannerParams& params)
      : why_blocked_(why_blocked), params_(params), random_(params.seed) {}

  bool IsFree(const Joints& a, const Joints& b) const {
    return !WhyEdgeBlocked(a, b, why_blocked_, params_);
  }

  std::vector<Joints> GrowTrees(const Joints& start,
                                const std::vector<Joints>& goals) {
    Tree from_start, from_goals;
    from_start.AddRoot(start);
    for (const Joints& goal : goals) from_goals.AddRoot(goal);
    Tree* growing = &from_start;
    Tree* other = &from_goals;
    for (int i = 0; i < params_.max_iterations; ++i) {
      if (GrowTowards(growing, Sample(start, goals))) {
        const size_t tip = growing->size() - 1;
        if (Connect(other, growing->at(tip))) {
          return Joined(from_start, from_goals,
                        growing == &from_start ? tip : from_start.size() - 1,
                        growing == &from_start ? from_goals.size() - 1 : tip);
        }
      }
      std::swap(growing, other);
    }
    return {};
  }

  // Replaces what lies between two random points of the path by a straight
  // line where that is free.
  void Shorten(std::vector<Joints>* path) {
    for (int i = 0; i < params_.shortcut_rounds && path->size() > 2; ++i) {
      const Cut a = RandomCut(*path), b = RandomCut(*path);
      const Cut& first = a.edge < b.edge ? a : b;
      const Cut& last = a.edge < b.edge ? b : a;
      if (first.edge == last.edge || !IsFree(first.q, last.q)) continue;
      std::vector<Joints> shorter(path->begin(),
                                  path->begin() + first.edge + 1);
      shorter.push_back(first.q);
      shorter.push_back(last.q);
      shorter.insert(shorter.end(), path->begin() + last.edge + 1, path->end());
      *path = std::move(shorter);
    }
    SkipWaypoints(path);
  }

 private:
  struct Cut {
    std::ptrdiff_t edge;
    Joints q;
  };

  Cut RandomCut(const std::vector<Joints>& path) {
    std::uniform_int_distribution<size_t> edge(0, path.size() - 2);
    std::uniform_real_distribution<double> share(0, 1);
    const size_t i = edge(random_);
    const double s = share(random_);
    return {static_cast<std::ptrdiff_t>(i),
            (1 - s) * path[i] + s * path[i + 1]};
  }

  // Every waypoint means a stop: the fewer the better.
  void SkipWaypoints(std::vector<Joints>* path) const {
    for (size_t i = 0; i + 2 < path->size(); ++i) {
      for (size_t j = path->size() - 1; j > i + 1; --j) {
        if (!IsFree((*path)[i], (*path)[j])) continue;
        const auto begin = path->begin() + static_cast<std::ptrdiff_t>(i);
        path->erase(begin + 1, path->begin() + static_cast<std::ptrdiff_t>(j));
        break;
      }
    }
  }

  // Uniform about the way from start to goals: far turns are of no use.
  Joints Sample(const Joints& start, const std::vector<Joints>& goals) {
    constexpr double kRoom = 1.2;  // [rad]
    std::uniform_int_distribution<size_t> choice(0, goals.size() - 1);
    const Joints& goal = goals[choice(random_)];
    Joints q;
    for (int i = 0; i < kNumJoints; ++i) {
      const double limit = params_.max_angle[i] - params_.joint_margin;
      const double low = std::min(start[i], goal[i]) - kRoom;
      const double high = std::max(start[i], goal[i]) + kRoom;
      q[i] = std::uniform_real_distribution<double>(
          std::max(low, -limit), std::min(high, limit))(random_);
    }
    return q;
  }

  // True if the tree grew.
  bool GrowTowards(Tree* tree, const Joints& q) const {
    const size_t nearest = tree->NearestTo(q);
    const Joints from = tree->at(nearest);
    const double way = (q - from).cwiseAbs().maxCoeff();
    if (way == 0) return false;
    const Joints to =
        from + std::min(1.0, params_.tree_step / way) * (q - from);
    if (!IsFree(from, to)) return false;
    tree->Add(to, nearest);
    return true;
  }

  // Grows until it reaches q or is blocked.
  bool Connect(Tree* tree, const Joints& q) const {
    while (GrowTowards(tree, q)) {
      if ((tree->at(tree->size() - 1) - q).cwiseAbs().maxCoeff() < 1e-9) {
        return true;
      }
    }
    return false;
  }

  static std::vector<Joints> Joined(const Tree& from_start,
                                    const Tree& from_goals, size_t start_tip,
                                    size_t goal_tip) {
    std::vector<Joints> path = from_start.WayToRoot(start_tip);
    std::ranges::reverse(path);
    const std::vector<Joints> rest = from_goals.WayToRoot(goal_tip);
    path.insert(path.end(), rest.begin() + 1, rest.end());
    return path;
  }

  const WhyBlockedAt& why_blocked_;
  const PathPlannerParams& params_;
  std::mt19937_64 random_;
};

}  // namespace

PathPlannerParams::PathPlannerParams(const ArmModel& model)
    : levers(model.levers()), max_angle(model.limits().angle) {}

std::optional<std::string> WhyEdgeBlocked(const Joints& a, const Joints& b,
                                          const WhyBlockedAt& why_blocked,
                                          const PathPlannerParams& params) {
  const double way = params.levers.dot((b - a).cwiseAbs());
  const int num =
      std::max(1, static_cast<int>(std::ceil(way / params.tip_step)));
  // The end first: it is where most edges fail.
  for (int i = num; i >= 1; --i) {
    const double share = static_cast<double>(i) / num;
    if (auto why = why_blocked(a + share * (b - a))) return why;
  }
  return std::nullopt;
}

WhyBlockedAt AskScene(const ArmScene& scene, const std::string& arm,
                      const ArmPosture& posture, const ClearanceRule& rule) {
  return [=](const Joints& q) {
    return scene.WhyBlocked(arm, {q, posture.grip, posture.opening}, rule);
  };
}

JointPath PlanPath(const Joints& start, const std::vector<Joints>& goals,
                   const std::vector<Joints>& vias,
                   const WhyBlockedAt& why_blocked,
                   const PathPlannerParams& params) {
  if (goals.empty()) return Reason{"there is no goal"};
  if (const auto why = why_blocked(start)) {
    return Reason{"at the start, " + *why};
  }
  std::vector<Joints> open;
  std::string reason;
  for (const Joints& goal : goals) {
    const auto why = why_blocked(goal);
    if (!why) open.push_back(goal);
    if (why && reason.empty()) reason = "at the goal, " + *why;
  }
  if (open.empty()) return Reason{reason};

  Search search(why_blocked, params);
  for (const Joints& goal : open) {
    if (search.IsFree(start, goal)) return std::vector<Joints>{start, goal};
  }
  for (const Joints& via : vias) {
    if (!search.IsFree(start, via)) continue;
    for (const Joints& goal : open) {
      if (search.IsFree(via, goal)) {
        return std::vector<Joints>{start, via, goal};
      }
    }
  }
  std::vector<Joints> path = search.GrowTrees(start, open);
  if (path.empty()) {
    const auto why = WhyEdgeBlocked(start, open.front(), why_blocked, params);
    return Reason{"no path around: " + why.value_or("the goal")};
  }
  search.Shorten(&path);
  return path;
}

}  // namespace cell
