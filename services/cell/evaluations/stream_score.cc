#include "services/cell/evaluations/stream_score.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <optional>

namespace cell::cli {
namespace {

using recognizer::RecognisedAction;
using enum Recording::TrueAction::Kind;

// The tracker's period, the lag of key frames, and the hand's way out.
constexpr int64_t kNearUs = 1'500'000;

bool IsOfTheMoment(const RecognisedAction& action,
                   const Recording::TrueAction& truth) {
  return action.part == truth.part &&
         std::llabs(action.place_utime - truth.utime) <= kNearUs;
}

bool IsAction(const Recording::TrueAction& truth) {
  return truth.kind == kPlaced || truth.kind == kTakenBack;
}

bool Says(const RecognisedAction& action, const Recording::TrueAction& truth,
          const std::string& name) {
  if (!IsOfTheMoment(action, truth)) return false;
  if (!IsAction(truth)) {
    return action.direction == ActionDirection::kUnknown ||
           (truth.kind == kTipped && action.arguments.size() == 1);
  }
  const auto direction = truth.kind == kPlaced ? ActionDirection::kForward
                                               : ActionDirection::kReversed;
  // An action without a site among its arguments has but one place to go.
  return action.direction == direction && action.name == name &&
         action.arguments.at(0) == truth.part &&
         (action.arguments.size() == 1 || action.arguments[1] == truth.site);
}

std::string TextOf(const RecognisedAction& action) {
  if (action.direction == ActionDirection::kUnknown) return "unknown";
  return fmt::format(
      "{}{}({})",
      action.direction == ActionDirection::kReversed ? "undone " : "",
      action.name, fmt::join(action.arguments, ", "));
}

std::string TextOf(const Recording::TrueAction& truth) {
  switch (truth.kind) {
    case kPlaced:
      return fmt::format("{} placed at {}", truth.part, truth.site);
    case kTakenBack:
      return fmt::format("{} taken back from {}", truth.part, truth.site);
    case kMoved:
      return truth.part + " moved";
    case kTipped:
      return truth.part + " laid down or raised";
  }
  return "";
}

/// Recognised actions, each of which can be used once.
class Recognised {
 public:
  explicit Recognised(const std::vector<RecognisedAction>& actions)
      : actions_(actions), is_used_(actions.size(), false) {}

  template <class Matches>
  const RecognisedAction* Use(Matches matches) {
    for (size_t i = 0; i < actions_.size(); ++i) {
      if (is_used_[i] || !matches(actions_[i])) continue;
      is_used_[i] = true;
      return &actions_[i];
    }
    return nullptr;
  }

 private:
  const std::vector<RecognisedAction>& actions_;
  std::vector<bool> is_used_;
};

void CountRight(const RecognisedAction& action, StreamScore* score) {
  const bool is_unknown = action.direction == ActionDirection::kUnknown;
  ++(is_unknown ? score->num_unknown_right : score->num_named_right);
  score->confidence_right.push_back(action.confidence);
}

void CountTruth(const Recording::TrueAction& truth, bool is_right,
                StreamScore* score) {
  if (!IsAction(truth)) {
    ++score->num_moves;
    score->num_moves_right += is_right;
    return;
  }
  ++score->num_actions;
  score->num_actions_right += is_right;
  if (truth.kind != kTakenBack) return;
  ++score->num_reversals;
  score->num_reversals_right += is_right;
}

}  // namespace

std::map<std::string, std::string> PlacementNames(
    const vtb::Demonstrations& demonstrations, const PartTable& parts) {
  std::map<std::string, std::string> names;
  for (const Part& part : parts.parts()) {
    for (const auto& [key, rule] : demonstrations.rules) {
      if (rule.part_type == part.type) names[part.name] = rule.called;
    }
  }
  return names;
}

StreamScore Score(const ShownStream& stream,
                  const std::map<std::string, std::string>& names) {
  StreamScore score;
  for (const RecognisedAction& action : stream.recognised) {
    ++(action.direction == ActionDirection::kUnknown ? score.num_unknown
                                                     : score.num_named);
  }
  Recognised recognised(stream.recognised);
  std::vector<const ShownStream::Done*> missed;
  for (const ShownStream::Done& done : stream.done) {
    const auto name = names.find(done.action.part);
    const RecognisedAction* right = recognised.Use([&](const auto& action) {
      return Says(action, done.action, name == names.end() ? "" : name->second);
    });
    CountTruth(done.action, right != nullptr, &score);
    if (right != nullptr) {
      CountRight(*right, &score);
    } else {
      missed.push_back(&done);
    }
  }
  const auto add_error = [&](const std::string& where, int64_t utime,
                             const std::string& what) {
    score.errors.push_back(fmt::format(
        "{}{:.2f} s: {}", where, static_cast<double>(utime) * 1e-6, what));
  };
  for (const ShownStream::Done* done : missed) {
    const RecognisedAction* wrong = recognised.Use([&](const auto& action) {
      return IsOfTheMoment(action, done->action);
    });
    if (wrong) score.confidence_wrong.push_back(wrong->confidence);
    add_error(done->demonstration + " at ",
              done->action.utime - done->begin_utime,
              fmt::format("{} is {}", TextOf(done->action),
                          wrong ? "recognised as " + TextOf(*wrong)
                                : "not recognised"));
  }
  while (const auto* left = recognised.Use([](const auto&) { return true; })) {
    score.confidence_wrong.push_back(left->confidence);
    add_error("stream at ", left->place_utime,
              fmt::format("{}: {} is recognised, but was not done", left->part,
                          TextOf(*left)));
  }
  return score;
}

std::vector<Measure> StreamMeasures(const StreamScore& s) {
  return {{"precision of recognised actions", s.num_named_right, s.num_named,
           std::nullopt, 0.98},
          {"recall of actions", s.num_actions_right, s.num_actions,
           std::nullopt, 0.98},
          {"undone actions recognised as reversed", s.num_reversals_right,
           s.num_reversals, std::nullopt, 0.98},
          {"unknown moves reported as unknown", s.num_moves_right, s.num_moves,
           std::nullopt, 0.98},
          {"manipulations reported as unknown that are", s.num_unknown_right,
           s.num_unknown, std::nullopt, 0}};
}

}  // namespace cell::cli
