#include "services/cell/explaining/action_explainer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "cell/action_record_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/key_frame_t.hpp"
#include "common/actions/record_messages.h"
#include "common/bus/decode.h"
#include "common/scene/key_frame.h"

namespace cell::cli {
namespace {

using recognizer::RecognisedAction;

constexpr size_t kNumOthers = 2;  // readings that were not chosen

/// What a manipulation may be read as.
struct Candidate {
  std::string text;
  double agreement = 0;
  std::vector<CheckedFact> facts;
  bool is_chosen = false;

  /// Of the facts, also where the agreement is 0 for lack of a required one.
  double HeldShare() const {
    double held = 0, all = 0;
    for (const CheckedFact& fact : facts) {
      held += fact.weight * fact.share;
      all += fact.weight;
    }
    return all > 0 ? held / all : 0;
  }
};

std::string Called(const std::string& name,
                   const std::vector<std::string>& arguments,
                   ActionDirection direction) {
  return fmt::format(
      "{}{}({})",
      direction == ActionDirection::kReversed ? "the reverse of " : "", name,
      fmt::join(arguments, ", "));
}

std::string TextOf(const RecognisedAction& action) {
  return action.direction == ActionDirection::kUnknown
             ? "an unknown manipulation"
             : Called(action.name, action.arguments, action.direction);
}

/// All readings that the library knows, best first.
std::vector<Candidate> CandidatesFor(
    const ObservedManipulation& manipulation,
    const std::vector<RecognisedAction>& actions, const SecLibrary& library) {
  std::vector<Candidate> candidates;
  for (const auto direction :
       {ActionDirection::kForward, ActionDirection::kReversed}) {
    for (const auto& model : library.models()) {
      for (const auto& roles : model->RolesAtPickUp(
               manipulation.part, manipulation.before, direction)) {
        Candidate candidate{Called(model->action(), roles, direction),
                            model->Agreement(manipulation, roles, direction),
                            model->Check(manipulation, roles, direction),
                            false};
        candidate.is_chosen =
            std::ranges::any_of(actions, [&](const RecognisedAction& action) {
              return TextOf(action) == candidate.text;
            });
        candidates.push_back(std::move(candidate));
      }
    }
  }
  std::ranges::stable_sort(candidates,
                           [](const Candidate& a, const Candidate& b) {
                             return std::pair(a.agreement, a.HeldShare()) >
                                    std::pair(b.agreement, b.HeldShare());
                           });
  return candidates;
}

/// "touches table, not Free(hole)"; empty if none is wanted.
template <class IsWanted>
std::string ListOf(const std::vector<CheckedFact>& facts, IsWanted is_wanted) {
  std::vector<std::string> texts;
  for (const CheckedFact& fact : facts) {
    if (is_wanted(fact)) texts.push_back(fact.text);
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

void AddFacts(const Candidate& candidate, bool with_held,
              std::vector<std::string>* lines) {
  using When = CheckedFact::When;
  const auto add = [&](const std::string& what, auto is_wanted) {
    const std::string list = ListOf(candidate.facts, is_wanted);
    if (!list.empty()) lines->push_back("  " + what + ": " + list);
  };
  for (const auto& [when, words] :
       {std::pair{When::kBefore, "before"}, {When::kAfter, "afterwards"}}) {
    if (with_held) {
      add(fmt::format("held {}", words), [&](const CheckedFact& fact) {
        return fact.when == when && fact.share == 1;
      });
    }
    add(fmt::format("open {}, half counted", words),
        [&](const CheckedFact& fact) {
          return fact.when == when && fact.share > 0 && fact.share < 1;
        });
    add(fmt::format("must hold {}, but did not", words),
        [&](const CheckedFact& fact) {
          return fact.when == when && fact.share == 0 && fact.is_required;
        });
    add(fmt::format("did not hold {}", words), [&](const CheckedFact& fact) {
      return fact.when == when && fact.share == 0 && !fact.is_required;
    });
  }
  add("changed, but the model does not say so",
      [](const CheckedFact& fact) { return fact.when == When::kUnexplained; });
}

void AddCandidate(const std::string& what, const Candidate& candidate,
                  std::vector<std::string>* lines) {
  lines->push_back(fmt::format("{}: {}, agreement {:.2f}", what, candidate.text,
                               candidate.agreement));
  AddFacts(candidate, candidate.is_chosen, lines);
}

double Seconds(int64_t utime) {
  return static_cast<double>(utime) * 1e-6;
}

std::vector<std::string> ReasonsFor(const std::vector<Candidate>& candidates,
                                    const RecognisedAction& action,
                                    double threshold) {
  std::vector<std::string> lines = {fmt::format(
      "{} held it from {:.2f} s (key frame {}) to {:.2f} s (key frame {})",
      fmt::join(action.hands, ", "), Seconds(action.pick_utime),
      action.pick_key_frame, Seconds(action.place_utime),
      action.place_key_frame)};
  if (candidates.empty()) {
    lines.push_back(
        "no model that is known moves such a part from where it was");
    return lines;
  }
  const bool is_unknown = action.direction == ActionDirection::kUnknown;
  if (is_unknown) {
    lines.push_back(fmt::format(
        "no model reaches an agreement of {:.2f}, and the part was moved",
        threshold));
  }
  size_t num_others = 0;
  for (const Candidate& candidate : candidates) {
    if (candidate.is_chosen) {
      if (candidate.text == TextOf(action)) {
        AddCandidate("chosen", candidate, &lines);
      }
    } else if (num_others < kNumOthers) {
      AddCandidate(num_others == 0 && is_unknown ? "nearest"
                   : num_others == 0             ? "next best"
                                                 : "then",
                   candidate, &lines);
      ++num_others;
    }
  }
  if (num_others == 0) lines.push_back("no other model came into question");
  return lines;
}

}  // namespace

ActionExplainer::ActionExplainer(const recognizer::Recognizer::Params& params)
    : params_(params), actions_(params.actions) {
  Begin();
}

std::vector<int64_t> ActionExplainer::Utimes() const {
  std::vector<int64_t> utimes;
  for (const Explanation& explanation : explanations_) {
    utimes.push_back(explanation.utime);
  }
  return utimes;
}

std::vector<Explanation> ActionExplainer::At(int64_t utime) const {
  std::vector<Explanation> explanations;
  for (const Explanation& explanation : explanations_) {
    if (explanation.utime == utime) explanations.push_back(explanation);
  }
  return explanations;
}

void ActionExplainer::Begin() {
  library_ = params_.make_library(actions_);
  recognition_ = std::make_unique<recognizer::Recognition>(
      params_.scene_objects, actions_.parts(), library_, params_.sensor,
      params_.recognition);
  recognition_->SetObserver(
      [this](const auto& manipulation, const auto& actions) {
        Explain(manipulation, actions);
      });
}

void ActionExplainer::Put(const Message& message) {
  if (message.channel == "EPISODE") {
    const auto episode = Decode<episode_t>(message);
    if (episode && episode->phase == episode_t::START) Begin();
  } else if (message.channel == "KEY_FRAME") {
    OnKeyFrame(message);
  } else if (message.channel == "ACTION_RECORD") {
    OnRecord(message);
  }
}

void ActionExplainer::OnKeyFrame(const Message& message) {
  const auto decoded = Decode<key_frame_t>(message);
  if (!decoded) return;
  const auto frame = KeyFrameFromMessage(*decoded, params_.scene_objects);
  if (frame) recognition_->Update(*frame);
}

void ActionExplainer::OnRecord(const Message& message) {
  const auto decoded = Decode<action_record_t>(message);
  if (!decoded) return;
  const auto update = actions_.Apply(FromMessage(*decoded));
  if (!update || *update != ActionModels::Update::kChanged) return;
  library_ = params_.make_library(actions_);
  recognition_->Use(library_);
}

void ActionExplainer::Explain(const ObservedManipulation& manipulation,
                              const std::vector<RecognisedAction>& actions) {
  const auto candidates = CandidatesFor(manipulation, actions, *library_);
  for (const RecognisedAction& action : actions) {
    explanations_.push_back(
        {action.place_utime,
         fmt::format("{} was moved: {}, confidence {:.2f}", manipulation.part,
                     TextOf(action), action.confidence),
         ReasonsFor(candidates, action, library_->threshold())});
  }
}

}  // namespace cell::cli
