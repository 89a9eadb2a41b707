#include "common/assemblies/sequence_judge.h"

#include <gmock/gmock.h>

#include <deque>

#include "common/rules/simulation.h"
#include "tests/unit/assemblies/small_assemblies.h"

namespace cell::assemblies {
namespace {

using testing::HasSubstr;

const PartPair kHub = MakePair("hub", "axle");
const PartPair kRim = MakePair("rim", "hub");
const PartPair kBell = MakePair("bell", "axle");

/// The hub comes before the rim; a bell any time.
AssemblyModel HubBeforeRim() {
  return LearnModel(
      EvidenceFrom(
          {MakeSequence(
               {"attach,rim,hub,mistake,wrong order",
                "detach,rim,hub,correction,", "attach,bell,axle,correct,",
                "attach,hub,axle,correct,", "attach,rim,hub,correct,"}),
           MakeSequence({"attach,hub,axle,correct,", "attach,rim,hub,correct,",
                         "attach,bell,axle,correct,"})}),
      {}, {});
}

TEST(SequenceJudge, ARightAssemblyShortensThePlanWithEachAction) {
  const AssemblyModel model = HubBeforeRim();
  SequenceJudge judge(model, {});
  EXPECT_EQ(judge.PlanLength(), 3);
  for (const PartPair& pair : {kBell, kHub, kRim}) {
    const Verdict verdict = judge.Judge(Verb::kAttach, pair);
    EXPECT_EQ(verdict.label, Label::kCorrect) << Show(pair);
    EXPECT_EQ(verdict.plan_after, verdict.plan_before - 1);
  }
  EXPECT_EQ(judge.PlanLength(), 0);
}

TEST(SequenceJudge, AWrongOrderLengthensThePlanAndItsUndoingIsACorrection) {
  const AssemblyModel model = HubBeforeRim();
  SequenceJudge judge(model, {});
  const Verdict mistake = judge.Judge(Verb::kAttach, kRim);
  EXPECT_EQ(mistake.label, Label::kMistake);
  EXPECT_EQ(mistake.kind, MistakeKind::kWrongOrder);
  EXPECT_EQ(mistake.plan_after, mistake.plan_before + 1);
  EXPECT_THAT(mistake.reason, HasSubstr("axle - hub"));
  const Verdict correction = judge.Judge(Verb::kDetach, kRim);
  EXPECT_EQ(correction.label, Label::kCorrection);
  EXPECT_EQ(correction.plan_after, 3);
}

TEST(SequenceJudge, UndoingWhatWasRightIsAMistake) {
  const AssemblyModel model = HubBeforeRim();
  SequenceJudge judge(model, {});
  judge.Judge(Verb::kAttach, kHub);
  const Verdict verdict = judge.Judge(Verb::kDetach, kHub);
  EXPECT_EQ(verdict.label, Label::kMistake);
  EXPECT_EQ(verdict.kind, MistakeKind::kShouldNotHaveHappened);
  EXPECT_EQ(verdict.plan_after, 3);
  EXPECT_THAT(judge.Judge(Verb::kDetach, kHub).reason,
              HasSubstr("nobody has seen it attached"));
}

TEST(SequenceJudge, APairThatNoAssemblyHoldsIsAMistakeUnlessItStandsForOne) {
  const AssemblyModel model = HubBeforeRim();
  SequenceJudge judge(model, {});
  judge.Judge(Verb::kAttach, kHub);
  // The rim meets axle and hub alike: one may name either.
  const Verdict variant = judge.Judge(Verb::kAttach, MakePair("rim", "axle"));
  EXPECT_EQ(variant.label, Label::kCorrect);
  EXPECT_THAT(variant.reason, HasSubstr("stands for hub - rim"));
  EXPECT_EQ(variant.plan_after, 1);
  judge.Judge(Verb::kAttach, kBell);
  const Verdict wrong = judge.Judge(Verb::kAttach, MakePair("bell", "rim"));
  EXPECT_EQ(wrong.label, Label::kMistake);
  EXPECT_EQ(wrong.kind, MistakeKind::kWrongPosition);
}

TEST(SequenceJudge, WhatBuildsOnAMistakeIsAMistake) {
  const AssemblyModel model = HubBeforeRim();
  for (const bool builds : {true, false}) {
    JudgeSettings settings;
    settings.builds_on_mistakes = builds;
    SequenceJudge judge(model, settings);
    judge.Judge(Verb::kAttach, kRim);
    const Verdict verdict = judge.Judge(Verb::kAttach, kHub);
    EXPECT_EQ(verdict.label, builds ? Label::kMistake : Label::kCorrect);
  }
}

TEST(SequenceJudge, KnowsNothingOfForeignPartsAndOfTwoOfOneName) {
  const AssemblyModel model = HubBeforeRim();
  SequenceJudge judge(model, {});
  for (const PartPair& pair :
       {MakePair("moon", "star"), MakePair("rim", "rim")}) {
    const Verdict verdict = judge.Judge(Verb::kAttach, pair);
    EXPECT_EQ(verdict.label, Label::kCorrect);
    EXPECT_EQ(verdict.plan_after, 3);
  }
}

TEST(SequenceJudge, APairThatIsMostlyMisplacedIsDoubtedOnce) {
  const AssemblyModel model = LearnModel(
      EvidenceFrom({MakeSequence({"attach,rim,hub,mistake,wrong position",
                                  "detach,rim,hub,correction,",
                                  "attach,rim,hub,correct,"})}),
      {}, {});
  SequenceJudge judge(model, {});
  EXPECT_EQ(judge.Judge(Verb::kAttach, kRim).kind, MistakeKind::kWrongPosition);
  EXPECT_EQ(judge.Judge(Verb::kDetach, kRim).label, Label::kCorrection);
  EXPECT_EQ(judge.Judge(Verb::kAttach, kRim).label, Label::kCorrect);
}

// A world of pairs of which each is absent, attached in the right way or in a
// wrong way; `required` by index.
struct PairWorld {
  std::vector<std::vector<size_t>> required;

  std::vector<int> Attach(std::vector<int> state, size_t pair) const {
    bool is_sound = true;
    for (const size_t other : required[pair]) is_sound &= state[other] != 0;
    state[pair] = is_sound ? 1 : 2;
    return state;
  }

  int ShortestPlan(const std::vector<int>& start) const {
    std::map<std::vector<int>, int> distances = {{start, 0}};
    std::deque<std::vector<int>> open = {start};
    for (;;) {
      const std::vector<int> state = open.front();
      open.pop_front();
      const int distance = distances.at(state);
      if (state == std::vector<int>(state.size(), 1)) return distance;
      for (size_t i = 0; i < state.size(); ++i) {
        std::vector<int> next = state;
        next[i] = 0;
        if (state[i] == 0) next = Attach(state, i);
        if (distances.emplace(next, distance + 1).second) open.push_back(next);
      }
    }
  }
};

TEST(SequenceJudge, ThePlansLengthIsThatOfBreadthFirstSearch) {
  rules::RandomNumbers random(1);
  const std::vector<std::string> names = {"a", "b", "c", "d", "e"};
  const auto pair_of = [&](size_t i) {
    return MakePair(names[i], "z");
  };
  JudgeSettings settings;
  settings.builds_on_mistakes = false;
  for (int trial = 0; trial < 30; ++trial) {
    PairWorld world{std::vector<std::vector<size_t>>(names.size())};
    std::vector<std::string> rows;
    for (size_t i = 0; i < names.size(); ++i) {
      rows.push_back("attach," + names[i] + ",z,correct,");
    }
    AssemblyModel model =
        LearnModel(EvidenceFrom({MakeSequence(rows)}), {}, settings);
    for (size_t i = 0; i < names.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        if (random.Uniform() > 0.4) continue;
        world.required[i].push_back(j);
        const auto& rules = model.rules.rules;
        const auto literal =
            rules[static_cast<size_t>(model.rule_of.at(pair_of(j)))]
                .outcomes[0]
                .changes[0];
        model.rules.rules[static_cast<size_t>(model.rule_of.at(pair_of(i)))]
            .context.push_back(literal);
      }
    }
    SequenceJudge judge(model, settings);
    std::vector<int> state(names.size(), 0);
    for (int step = 0; step < 12; ++step) {
      const auto i = static_cast<size_t>(random.Below(5));
      const bool attaches = state[i] == 0;
      if (attaches) {
        state = world.Attach(state, i);
      } else {
        state[i] = 0;
      }
      judge.Judge(attaches ? Verb::kAttach : Verb::kDetach, pair_of(i));
      ASSERT_EQ(judge.PlanLength(), world.ShortestPlan(state));
    }
  }
}

}  // namespace
}  // namespace cell::assemblies
