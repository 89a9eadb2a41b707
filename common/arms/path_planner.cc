#include "common/arms/path_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "common/arms/ur5.h"

namespace cell {
namespace {

using Path = std::vector<Joints>;

double Way(const Joints& a, const Joints& b) {
  return (b - a).cwiseAbs().maxCoeff();
}

struct Tree {
  struct Node {
    Joints q;
    int parent;
  };
  std::vector<Node> nodes;

  explicit Tree(const Joints& root) : nodes{{root, -1}} {}

  int Nearest(const Joints& q) const {
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < nodes.size(); ++i) {
      const double distance = (nodes[i].q - q).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = static_cast<int>(i);
    }
    return nearest;
  }
  /// From the root to the node.
  Path PathTo(int node) const {
    Path path;
    for (; node >= 0; node = nodes[static_cast<size_t>(node)].parent) {
      path.push_back(nodes[static_cast<size_t>(node)].q);
    }
    std::ranges::reverse(path);
    return path;
  }
};

/// Grows the tree from its nearest node towards `q` by at most `reach`; the
/// new node, -1 if the way is blocked.
template <class IsStraightFree>
int Grow(Tree& tree, const Joints& q, double reach,
         const IsStraightFree& is_straight_free) {
  const int nearest = tree.Nearest(q);
  const Joints from = tree.nodes[static_cast<size_t>(nearest)].q;
  const double way = Way(from, q);
  const Joints to =
      way <= reach ? q : Joints(from + (reach / way) * (q - from));
  if (!is_straight_free(from, to)) return -1;
  tree.nodes.push_back({to, nearest});
  return static_cast<int>(tree.nodes.size()) - 1;
}

template <class IsStraightFree>
std::optional<Path> Connect(const Joints& from, const Joints& to,
                            const PathPlanner::Params& params,
                            std::mt19937_64& random,
                            const IsStraightFree& is_straight_free) {
  Tree trees[2] = {Tree(from), Tree(to)};
  int grown = 0;  // the tree whose turn it is
  for (int i = 0; i < params.max_tries; ++i) {
    Joints q;
    for (int j = 0; j < 6; ++j) {
      const double low = std::min(from[j], to[j]) - params.margin;
      const double high = std::max(from[j], to[j]) + params.margin;
      q[j] = std::uniform_real_distribution<double>(
          std::max(low, -ur5::kJointLimit),
          std::min(high, ur5::kJointLimit))(random);
    }
    const int reached = Grow(trees[grown], q, params.reach, is_straight_free);
    if (reached < 0) continue;
    const Joints target = trees[grown].nodes.back().q;
    int met = 0;
    while ((met = Grow(trees[1 - grown], target, params.reach,
                       is_straight_free)) >= 0) {
      if (trees[1 - grown].nodes.back().q != target) continue;
      Path path = trees[0].PathTo(grown == 0 ? reached : met);
      Path rest = trees[1].PathTo(grown == 0 ? met : reached);
      std::ranges::reverse(rest);
      path.insert(path.end(), rest.begin() + 1, rest.end());
      return path;
    }
    grown = 1 - grown;
  }
  return std::nullopt;
}

}  // namespace

bool PathPlanner::IsStraightFree(const Joints& a, const Joints& b,
                                 const IsFree& is_free) const {
  const int num =
      std::max(1, static_cast<int>(std::ceil(Way(a, b) / params_.step)));
  for (int i = 1; i <= num; ++i) {
    if (!is_free(a + (static_cast<double>(i) / num) * (b - a))) return false;
  }
  return true;
}

std::optional<Path> PathPlanner::Find(const Joints& from, const Joints& to,
                                      const Path& via,
                                      const IsFree& is_free) const {
  const auto is_straight_free = [&](const Joints& a, const Joints& b) {
    return IsStraightFree(a, b, is_free);
  };
  if (!is_free(to)) return std::nullopt;
  if (is_straight_free(from, to)) return Path{from, to};
  for (const Joints& q : via) {
    if (is_straight_free(from, q) && is_straight_free(q, to)) {
      return Path{from, q, to};
    }
  }
  for (const Joints& a : via) {
    if (!is_straight_free(from, a)) continue;
    for (const Joints& b : via) {
      if (a != b && is_straight_free(b, to) && is_straight_free(a, b)) {
        return Path{from, a, b, to};
      }
    }
  }
  std::mt19937_64 random(params_.seed);
  auto path = Connect(from, to, params_, random, is_straight_free);
  if (!path) return std::nullopt;
  for (int i = 0; i < params_.num_shortcuts && path->size() > 2; ++i) {
    std::uniform_int_distribution<size_t> draw(0, path->size() - 1);
    size_t a = draw(random), b = draw(random);
    if (a > b) std::swap(a, b);
    if (b - a < 2 || !is_straight_free((*path)[a], (*path)[b])) continue;
    path->erase(path->begin() + static_cast<std::ptrdiff_t>(a) + 1,
                path->begin() + static_cast<std::ptrdiff_t>(b));
  }
  return path;
}

}  // namespace cell
