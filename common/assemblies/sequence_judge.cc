#include "common/assemblies/sequence_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace cell::assemblies {
namespace {

std::string ShowAll(const std::vector<PartPair>& pairs) {
  std::string text;
  for (const PartPair& pair : pairs) {
    text += (text.empty() ? "" : ", ") + Show(pair);
  }
  return text;
}

}  // namespace

SequenceJudge::SequenceJudge(const AssemblyModel& model,
                             const JudgeSettings& settings)
    : model_(model),
      settings_(settings),
      world_(model.rules.symbols, {}),
      state_(world_.EmptyState()),
      joined_(*model.rules.symbols->Find("joined")) {}

Verdict SequenceJudge::Judge(Verb verb, const PartPair& pair) {
  return verb == Verb::kAttach ? JudgeAttach(pair) : JudgeDetach(pair);
}

int SequenceJudge::PlanLength() const {
  int length = static_cast<int>(model_.goal.size());
  for (const auto& [pair, standing] : standing_) {
    if (!standing.is_sound) {
      ++length;
    } else if (model_.goal.contains(pair) || standing.stands_for) {
      --length;
    }
  }
  return length;
}

std::vector<PartPair> SequenceJudge::MissingFor(const PartPair& pair) const {
  std::vector<PartPair> missing;
  const auto it = model_.rule_of.find(pair);
  if (it == model_.rule_of.end()) return missing;
  const rules::Rule& rule = model_.rules.rules[static_cast<size_t>(it->second)];
  for (const rules::Literal& literal : rule.context) {
    if (!rules::Holds(literal, {}, state_, world_)) {
      missing.push_back(PairOf(literal, model_.rules));
    }
  }
  return missing;
}

double SequenceJudge::WrongPositionShare(const PartPair& pair) const {
  const auto it = model_.rule_of.find(pair);
  if (it == model_.rule_of.end() || pair.is_of_one_name()) return 0;
  const auto& outcomes =
      model_.rules.rules[static_cast<size_t>(it->second)].outcomes;
  return outcomes.size() > 1 ? outcomes[1].probability : 0;
}

bool SequenceJudge::AreConnected(const std::string& a,
                                 const std::string& b) const {
  std::set<std::string> reached = {a};
  for (size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [pair, standing] : standing_) {
      if (reached.contains(pair.first) || reached.contains(pair.second)) {
        reached.insert({pair.first, pair.second});
      }
    }
  }
  return reached.contains(b);
}

std::optional<PartPair> SequenceJudge::OpenGoalBetween(
    const PartPair& pair) const {
  for (const PartPair& goal : model_.goal) {
    if (standing_.contains(goal)) continue;
    const bool is_taken = std::ranges::any_of(
        standing_, [&](const auto& s) { return s.second.stands_for == goal; });
    if (is_taken) continue;
    if ((AreConnected(goal.first, pair.first) &&
         AreConnected(goal.second, pair.second)) ||
        (AreConnected(goal.first, pair.second) &&
         AreConnected(goal.second, pair.first))) {
      return goal;
    }
  }
  return {};
}

bool SequenceJudge::IsUnknown(const PartPair& pair) const {
  return !model_.parts.contains(pair.first) ||
         !model_.parts.contains(pair.second);
}

std::optional<SequenceJudge::Fault> SequenceJudge::FaultOf(
    const PartPair& pair, const std::optional<PartPair>& stands_for) const {
  if (pair.is_of_one_name()) return {};
  if (const auto missing = MissingFor(pair); !missing.empty()) {
    return Fault{
        MistakeKind::kWrongOrder,
        fmt::format("its rule requires {}, which {} not attached yet",
                    ShowAll(missing), missing.size() == 1 ? "is" : "are")};
  }
  if (!model_.goal.contains(pair) && !IsUnknown(pair) && !stands_for) {
    return Fault{MistakeKind::kWrongPosition,
                 "no assembly holds this pair, and no pair that is still to be "
                 "attached joins these parts"};
  }
  if (settings_.builds_on_mistakes && !order_.empty()) {
    const PartPair& last = order_.back();
    if (last != pair && last.Touches(pair) && !standing_.at(last).is_sound) {
      return Fault{
          MistakeKind::kPreviousIsMistake,
          fmt::format("{} below it has to be undone first", Show(last))};
    }
  }
  const double share = WrongPositionShare(pair);
  if (share >= settings_.least_wrong_position &&
      !num_attaches_.contains(pair)) {
    return Fault{
        MistakeKind::kWrongPosition,
        fmt::format("its rule expects a wrong position in {:.0f} % of first "
                    "attaches",
                    100 * share)};
  }
  return {};
}

void SequenceJudge::SetJoined(const PartPair& pair, bool is_joined) {
  const auto first = world_.FindObject(pair.first);
  const auto second = world_.FindObject(pair.second);
  if (!first || !second) return;  // no rule names it
  const std::array<int, 2> objects = {*first, *second};
  rules::World::Set(&state_, world_.PlaceOf(joined_, objects), is_joined);
}

void SequenceJudge::Attach(const PartPair& pair, const Standing& standing) {
  standing_[pair] = standing;
  std::erase(order_, pair);
  order_.push_back(pair);
  ++num_attaches_[pair];
  SetJoined(pair, true);
  if (standing.stands_for) SetJoined(*standing.stands_for, true);
}

Verdict SequenceJudge::JudgeAttach(const PartPair& pair) {
  Verdict verdict;
  verdict.plan_before = PlanLength();
  std::optional<PartPair> stands_for;
  if (!model_.goal.contains(pair)) stands_for = OpenGoalBetween(pair);
  const auto fault = FaultOf(pair, stands_for);
  Attach(pair, {!fault.has_value(), fault ? std::nullopt : stands_for});
  verdict.plan_after = PlanLength();
  if (fault) {
    verdict.label = Label::kMistake;
    verdict.kind = fault->kind;
    verdict.reason = fault->reason;
  } else if (stands_for) {
    verdict.reason = "stands for " + Show(*stands_for);
  } else if (!model_.goal.contains(pair)) {
    verdict.reason = "nothing was learned of this pair";
  }
  return verdict;
}

Verdict SequenceJudge::JudgeDetach(const PartPair& pair) {
  Verdict verdict;
  verdict.plan_before = PlanLength();
  const auto it = standing_.find(pair);
  const bool stands = it != standing_.end();
  if (stands && !it->second.is_sound) {
    verdict.label = Label::kCorrection;
    verdict.reason = "it was attached in a wrong way";
  } else {
    verdict.label = Label::kMistake;
    verdict.kind = MistakeKind::kShouldNotHaveHappened;
    verdict.reason = stands ? "it was attached in the right way"
                            : "nobody has seen it attached";
  }
  SetJoined(pair, false);
  if (stands) {
    if (it->second.stands_for) SetJoined(*it->second.stands_for, false);
    standing_.erase(it);
  }
  std::erase(order_, pair);
  verdict.plan_after = PlanLength();
  return verdict;
}

}  // namespace cell::assemblies
