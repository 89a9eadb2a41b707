#include "common/planning/end_components.h"

#include <algorithm>
#include <cstddef>

namespace cell::planning {
namespace {

size_t At(int i) {
  return static_cast<size_t>(i);
}

/// Strongly connected components by the choices that are left (Tarjan, without
/// recursion). The component's number of each node.
class Components {
 public:
  Components(const LocalGraph& graph,
             const std::vector<std::vector<char>>& is_left)
      : graph_(graph),
        is_left_(is_left),
        number_(graph.size(), -1),
        low_(graph.size()),
        component_(graph.size(), -1) {
    for (size_t node = 0; node < graph.size(); ++node) {
      if (number_[node] < 0) Explore(static_cast<int>(node));
    }
  }

  const std::vector<int>& component_of() const { return component_; }

 private:
  struct Frame {
    int node;
    size_t choice = 0;
    size_t target = 0;
  };

  void Open(int node) {
    number_[At(node)] = low_[At(node)] = num_numbered_++;
    stack_.push_back(node);
    frames_.push_back({node});
  }

  /// The next target of the frame's node; -1 after the last one.
  int Next(Frame& frame) const {
    const auto& choices = graph_[At(frame.node)];
    while (frame.choice < choices.size()) {
      if (is_left_[At(frame.node)][frame.choice] != 0 &&
          frame.target < choices[frame.choice].size()) {
        return choices[frame.choice][frame.target++];
      }
      ++frame.choice;
      frame.target = 0;
    }
    return -1;
  }

  void Explore(int root) {
    Open(root);
    while (!frames_.empty()) {
      const int node = frames_.back().node;
      const int target = Next(frames_.back());
      if (target < 0) {
        Close(node);
      } else if (number_[At(target)] < 0) {
        Open(target);
      } else if (component_[At(target)] < 0) {
        low_[At(node)] = std::min(low_[At(node)], number_[At(target)]);
      }
    }
  }

  void Close(int node) {
    frames_.pop_back();
    if (!frames_.empty()) {
      int& low = low_[At(frames_.back().node)];
      low = std::min(low, low_[At(node)]);
    }
    if (low_[At(node)] != number_[At(node)]) return;
    int member = -1;
    do {
      member = stack_.back();
      stack_.pop_back();
      component_[At(member)] = num_components_;
    } while (member != node);
    ++num_components_;
  }

  const LocalGraph& graph_;
  const std::vector<std::vector<char>>& is_left_;
  std::vector<int> number_, low_, component_;
  std::vector<int> stack_;
  std::vector<Frame> frames_;
  int num_numbered_ = 0;
  int num_components_ = 0;
};

}  // namespace

std::vector<std::vector<int>> EndComponents(const LocalGraph& graph) {
  std::vector<std::vector<char>> is_left;
  for (const auto& choices : graph) is_left.emplace_back(choices.size(), 1);
  std::vector<int> component_of;
  // A choice that leaves its component is taken away until none does.
  for (bool is_stable = false; !is_stable;) {
    is_stable = true;
    component_of = Components(graph, is_left).component_of();
    for (size_t node = 0; node < graph.size(); ++node) {
      for (size_t c = 0; c < graph[node].size(); ++c) {
        if (is_left[node][c] == 0) continue;
        const bool stays = std::ranges::all_of(graph[node][c], [&](int target) {
          return component_of[At(target)] == component_of[node];
        });
        if (stays) continue;
        is_left[node][c] = 0;
        is_stable = false;
      }
    }
  }
  std::vector<std::vector<int>> components;
  std::vector<int> place(graph.size(), -1);  // of each component
  for (size_t node = 0; node < graph.size(); ++node) {
    if (std::ranges::count(is_left[node], 1) == 0) continue;
    int& p = place[At(component_of[node])];
    if (p < 0) {
      p = static_cast<int>(components.size());
      components.emplace_back();
    }
    components[At(p)].push_back(static_cast<int>(node));
  }
  return components;
}

}  // namespace cell::planning
