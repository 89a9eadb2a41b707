#include "common/planning/bound_search.h"

#include <algorithm>

namespace cell::planning {
namespace {

constexpr int kMaxSweeps = 200;
constexpr double kConverged = 1e-14;
constexpr int64_t kExpansionsPerCheck = 4096;

}  // namespace

bool BoundSearch::IsSpent(const Budget& budget) {
  if (graph_.num_expansions() >= memory_.next) {
    memory_.next = graph_.num_expansions() + kExpansionsPerCheck;
    const auto own =
        static_cast<int64_t>(marks_.capacity() * sizeof(Mark) +
                             tried_in_.capacity() * sizeof(int64_t));
    memory_.is_spent =
        graph_.num_bytes() + bounds_.num_bytes() + own > budget.max_bytes;
  }
  return memory_.is_spent || graph_.num_expansions() >= budget.max_expansions;
}

bool BoundSearch::TryExpand(int state, const Budget& budget) {
  if (graph_.IsExpanded(state)) return true;
  if (IsSpent(budget)) return false;
  graph_.Expand(state);
  bounds_.Extend();
  return true;
}

bool BoundSearch::Solve(int state, double precision, const Budget& budget,
                        const MayGoOn& may_go_on) {
  budget_ = budget;
  precision_ = precision;
  bounds_.Extend();
  // Unlikely paths wait until the likely ones are known.
  if (!is_restored_) cut_ = 1e-2 * bounds_.width(state);
  is_restored_ = false;
  while (bounds_.width(state) > precision) {
    const double before = bounds_.width(state);
    has_changed_ = false;
    for (const Bound bound : {Bound::kUpper, Bound::kLower}) {
      Pass(bounds_.BlockOf(state), bound);
      if (bounds_.width(state) <= precision) return true;
    }
    if (IsSpent(budget)) return false;
    if (!has_changed_ && cut_ == 0) return false;  // at the limit of rounding
    if (before - bounds_.width(state) < 0.1 * before) {
      cut_ = cut_ > 1e-13 ? 0.1 * cut_ : 0;
    }
    if (may_go_on && !may_go_on()) return false;
  }
  return true;
}

void BoundSearch::Save(StateWriter* out) const {
  out->Put(cut_);
  out->Put(pass_);
  out->Put(memory_.next);
  out->Put(memory_.is_spent);
  out->Put(marks_);
  out->Put(tried_in_);
}

void BoundSearch::Restore(StateReader* in) {
  in->Get(&cut_);
  in->Get(&pass_);
  in->Get(&memory_.next);
  in->Get(&memory_.is_spent);
  in->Get(&marks_);
  in->Get(&tried_in_);
  is_restored_ = true;
}

bool BoundSearch::IsWorthEntering(int block, double reach) {
  const double width = bounds_.width(block);
  return width > 0.5 * precision_ && reach * width > cut_;
}

int BoundSearch::Chosen(const ProbabilityBounds::Update& update) const {
  return followed_ == Bound::kUpper ? update.choice : update.safe_choice;
}

void BoundSearch::Pass(int root, Bound bound) {
  ++pass_;
  followed_ = bound;
  num_numbered_ = 0;
  Open(root, 1);
  while (!frames_.empty()) Step();
}

void BoundSearch::Open(int block, double reach) {
  if (!graph_.IsExpanded(block)) {
    if (!TryExpand(block, budget_)) return;
    has_changed_ = true;
  }
  marks_.resize(static_cast<size_t>(graph_.size()));
  MarkOf(block) = {pass_, num_numbered_, num_numbered_, true};
  ++num_numbered_;
  stack_.push_back(block);
  const auto update = bounds_.Improve(block);
  has_changed_ |= update.change > kConverged;
  frames_.push_back({block, Chosen(update), 0, reach});
}

void BoundSearch::Step() {
  Frame& frame = frames_.back();
  if (frame.choice >= 0) {
    const auto outcomes = graph_.outcomes(graph_.choice(frame.choice));
    while (frame.outcome < static_cast<int>(outcomes.size())) {
      const auto& outcome = outcomes[static_cast<size_t>(frame.outcome++)];
      const int next = bounds_.BlockOf(outcome.state);
      const double reach = frame.reach * outcome.probability;
      if (static_cast<size_t>(next) < marks_.size() &&
          MarkOf(next).pass == pass_) {
        if (MarkOf(next).is_open) {
          int& low = MarkOf(frame.block).low;
          low = std::min(low, MarkOf(next).number);
        }
      } else if (IsWorthEntering(next, reach)) {
        Open(next, reach);
        return;
      }
    }
    if (ChooseAgain(&frame)) return;
  }
  Close();
}

bool BoundSearch::ChooseAgain(Frame* frame) {
  const auto size = static_cast<size_t>(frame->choice) + 1;
  if (tried_in_.size() < size) tried_in_.resize(2 * size);
  tried_in_[static_cast<size_t>(frame->choice)] = pass_;
  const auto update = bounds_.Improve(frame->block);
  has_changed_ |= update.change > kConverged;
  // While the upper bound stays the same, a new best choice here changes
  // nothing in the states above.
  const bool is_lower = update.drop > kConverged && followed_ == Bound::kUpper;
  if (Chosen(update) < 0 || is_lower ||
      !IsWorthEntering(frame->block, frame->reach)) {
    return false;
  }
  const auto chosen = static_cast<size_t>(Chosen(update));
  if (chosen < tried_in_.size() && tried_in_[chosen] == pass_) return false;
  frame->choice = Chosen(update);
  frame->outcome = 0;
  return true;
}

void BoundSearch::Close() {
  const int block = frames_.back().block;
  frames_.pop_back();
  const Mark& mark = MarkOf(block);
  if (!frames_.empty()) {
    int& low = MarkOf(frames_.back().block).low;
    low = std::min(low, mark.low);
  }
  if (mark.low != mark.number) return;
  std::vector<int> blocks;
  do {
    blocks.push_back(stack_.back());
    MarkOf(blocks.back()).is_open = false;
    stack_.pop_back();
  } while (blocks.back() != block);
  if (blocks.size() > 1) Converge(std::move(blocks));
}

double BoundSearch::Sweep(const std::vector<int>& blocks) {
  double change = 0;
  for (const int block : blocks) {
    change = std::max(change, bounds_.Improve(block).change);
  }
  has_changed_ |= change > kConverged;
  return change;
}

void BoundSearch::Converge(std::vector<int> blocks) {
  while (true) {
    for (int i = 0; i < kMaxSweeps && Sweep(blocks) > kConverged; ++i) {
    }
    const bool is_solved = std::ranges::all_of(blocks, [&](int block) {
      return bounds_.width(block) <= 0.5 * precision_;
    });
    if (is_solved || !bounds_.CollapseEndComponents(blocks)) return;
    has_changed_ = true;
    for (int& block : blocks) block = bounds_.BlockOf(block);
    std::vector<int> heads;
    for (const int block : blocks) {
      if (std::ranges::find(heads, block) == heads.end()) {
        heads.push_back(block);
      }
    }
    blocks = std::move(heads);
  }
}

}  // namespace cell::planning
