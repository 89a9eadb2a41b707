// Why the planner decided what it did, said from what it decided by.
#include "services/cell/explaining/decision_explainer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "services/planner/execute.h"
#include "services/planner/plan_search.h"
#include "services/planner/watch.h"
#include "tests/unit/bench_domain.h"
#include "tests/unit/cranfield_domain.h"

namespace cell {

using namespace cli;
using namespace planner;
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr int64_t kStepUs = 96'000;

/// The robot at the bench; what is sensed and what arms reach is a test's.
class ExplainedBench : public testing::Test {
 protected:
  void Begin(const std::string& goal, bool is_verbose = false) {
    explainer_ = std::make_unique<DecisionExplainer>(is_verbose);
    observer_ = explainer_->Observer();
    execute_ =
        std::make_unique<Execute>(bench_.rules, bench_.GoalOf(goal),
                                  PlanSearch::Maker({}), params_, true, now_);
  }

  void Step(int num_steps) {
    for (int i = 0; i < num_steps; ++i) {
      now_.utime += kStepUs;
      now_.tick += 12;
      for (const char* arm : {"left", "right"}) {
        execute_->OnArmState(ArmState{bench_.Object(arm), now_.utime,
                                      requests_[arm], std::nullopt,
                                      ReachOf(arm), SkillsOfBench()});
      }
      execute_->OnSensed(
          {0, now_.utime, bench_.StateOf(is_true_, is_unknown_)});
      const Decisions decisions = execute_->Decide(now_);
      for (const SkillRequest& request : decisions.requests) {
        requests_[bench_.Name(request.arm)] = request.id;
      }
      if (decisions.plan || decisions.execution ||
          !decisions.requests.empty() || !decisions.alerts.empty()) {
        observer_(now_, decisions, execute_->Basis());
      }
    }
  }
  void End(const std::string& arm, SkillResult::Outcome outcome,
           const std::string& reason) {
    execute_->OnSkillResult(
        {requests_.at(arm), now_.utime, bench_.Object(arm), outcome, reason});
    requests_[arm] = ArmState::kIdle;
  }

  std::vector<int> ReachOf(const std::string& arm) const {
    std::vector<int> objects;
    for (const std::string& part : reach_.at(arm)) {
      objects.push_back(bench_.Object(part));
    }
    return objects;
  }
  /// The last explanation that says `what`; its reasons.
  Reasons Why(const std::string& what) const {
    Reasons found;
    std::string others;
    for (const int64_t utime : explainer_->Utimes()) {
      for (const Explanation& explanation : explainer_->At(utime)) {
        others += explanation.what + "\n";
        if (explanation.what.find(what) != std::string::npos) {
          found = explanation.reasons;
        }
      }
    }
    EXPECT_THAT(found, Not(IsEmpty())) << "explained is: " << others;
    if (found.empty()) found.emplace_back("not explained");
    return found;
  }

  BenchDomain bench_;
  ExecutionParams params_;
  std::map<std::string, std::set<std::string>> reach_ = {
      {"left", {}}, {"right", {"bolt_1", "bolt_2", "lid"}}};
  std::map<std::string, int64_t> requests_ = {{"left", ArmState::kIdle},
                                              {"right", ArmState::kIdle}};
  std::set<std::string> is_true_, is_unknown_;
  Instant now_{1'000'000, 125};
  std::unique_ptr<DecisionExplainer> explainer_;
  DecisionObserver observer_;
  std::unique_ptr<Execute> execute_;
};

constexpr char kInsertBolt1[] =
    "the right arm was asked to insert(bolt_1, hole_1), which is "
    "Insert(bolt_1, hole_1)";

TEST_F(ExplainedBench, AnActionIsChosenByARuleAndWhatItIsWorth) {
  Begin("done");
  Step(10);
  const Reasons why = Why(kInsertBolt1);
  EXPECT_THAT(why, Contains("it is the first step of the best plan to the goal "
                            "'done'"));
  EXPECT_THAT(why, Contains("by this rule (version 1):"));
  EXPECT_THAT(why, Contains("  Action: Insert(bolt_1, hole_1)"));
  EXPECT_THAT(why, Contains(AllOf(StartsWith("  Preconditions: "),
                                  HasSubstr("not In(bolt_1, _)"),
                                  HasSubstr("Reachable(right, bolt_1)"))));
  EXPECT_THAT(why, Contains(HasSubstr("    0.90: ")));
  // Three actions, each of which succeeds in nine of ten cases.
  EXPECT_THAT(why, Contains("it reaches the goal with probability 1.00, 3.33 "
                            "actions expected; it counts on an outcome of "
                            "probability 0.90"));
  EXPECT_THAT(why, Contains(AllOf(StartsWith("next best: Insert(bolt_1, "
                                             "hole_2)"),
                                  HasSubstr("3.33 actions expected: as "
                                            "good"))));
  EXPECT_THAT(why, Not(Contains(StartsWith("not possible"))));
  EXPECT_THAT(why, Contains(StartsWith("the plan: 3.33 actions expected: "
                                       "Insert(bolt_1, hole_1)")));
}

TEST_F(ExplainedBench, OnRequestItIsSaidWhatTheOthersLack) {
  Begin("done", true);
  Step(10);
  const Reasons why = Why(kInsertBolt1);
  EXPECT_THAT(why, Contains("not possible: Close(lid) needs In(_, hole_1), "
                            "In(_, hole_2)"));
  EXPECT_THAT(why, Contains("not possible: PutDown(lid, left) needs "
                            "Held(lid, left)"));
}

TEST_F(ExplainedBench, AnActionThatLeadsNowhereIsSaidTo) {
  // Who closes the lid early cannot insert anything more.
  bench_ = BenchDomain(BenchWith(
      "context: [\"In(_, hole_1)\", \"In(_, hole_2)\", not Closed(X)]\n"
      "        outcomes: [{probability: 0.9, effects: [Closed(X)]}]\n"
      "        noise: 0.1",
      "context: [not Closed(X)]\n"
      "        outcomes: [{probability: 1, effects: [Closed(X)]}]\n"
      "        noise: 0"));
  Begin("one", true);
  Step(10);
  EXPECT_THAT(Why(kInsertBolt1),
              Contains(AllOf(StartsWith("leads nowhere: Close(lid): "),
                             HasSubstr("needs not Closed(lid)"))));
}

TEST_F(ExplainedBench, AHandoverBeforeItsTurnIsSaidToBeOne) {
  reach_ = {{"left", {"bolt_2"}}, {"right", {"bolt_1", "lid"}}};
  Begin("done");
  Step(10);
  const Reasons why = Why("the left arm was asked to present(bolt_2)");
  EXPECT_THAT(why[0], AllOf(StartsWith("it hands over beforehand"),
                            HasSubstr("of the plan")));
  EXPECT_THAT(why, Contains("  Action: Present(bolt_2)"));
}

TEST_F(ExplainedBench, AQuestionNamesTheRuleWhosePreconditionIsMissing) {
  reach_["right"] = {};
  is_true_ = {"In(bolt_2, hole_2)"};
  Begin("one");
  Step(80);
  const Reasons why = Why("the robot asked: bolt_1 is out of reach");
  EXPECT_THAT(why[0], StartsWith("no plan leads to the goal 'one': "));
  EXPECT_THAT(why, Contains("needed: Reachable(right, bolt_1)"));
  EXPECT_THAT(why, Contains("Insert(bolt_1, hole_1) has this precondition in "
                            "this rule (version 1):"));
  EXPECT_THAT(why, Contains("  Action: Insert(bolt_1, hole_1)"));
  EXPECT_THAT(why, Contains("  of which it lacks: Reachable(right, bolt_1)"));
  EXPECT_THAT(why, Contains("if that were so: 1.11 actions expected: "
                            "Insert(bolt_1, hole_1)"));
}

TEST_F(ExplainedBench, AQuestionAfterFailuresCountsThem) {
  params_.dispatch.max_attempts = 2;
  reach_["right"] = {"bolt_1"};
  is_true_ = {"In(bolt_2, hole_2)"};
  Begin("one");
  for (int attempt = 0; attempt < 2; ++attempt) {
    Step(10);
    End("right", SkillResult::Outcome::kFailed, "it slipped");
  }
  Step(80);
  const Reasons why = Why("the robot asked: the right arm has tried 2 times");
  EXPECT_THAT(why, Contains("Insert(bolt_1, hole_1) has failed 2 times in this "
                            "state and is not counted on: it slipped"));
  EXPECT_THAT(why, Contains(StartsWith("without these failures the plan would "
                                       "be: 1.11 actions expected")));
}

TEST_F(ExplainedBench, AnActionTriedAgainSaysHowOftenItHasFailed) {
  Begin("done");
  Step(10);
  End("right", SkillResult::Outcome::kFailed, "it slipped");
  Step(10);
  EXPECT_THAT(Why(kInsertBolt1),
              Contains("Insert(bolt_1, hole_1) has failed 1 time in this "
                       "state: it slipped"));
}

TEST_F(ExplainedBench, AQuestionAboutAStepOfThePersonSaysSo) {
  params_.help_steps = {bench_.Action("Close", {"lid"})};
  is_true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Begin("done");
  Step(10);
  const Reasons why = Why("the robot asked: please do Close(lid)");
  EXPECT_THAT(why, Contains("the best plan begins with Close(lid)"));
  EXPECT_THAT(why, Contains("this step is left to a person (help_steps)"));
}

TEST_F(ExplainedBench, AQuestionAboutWhatCannotBeSensedNamesIt) {
  is_unknown_ = {"In(bolt_1, hole_1)"};
  Begin("one");
  Step(80);
  EXPECT_THAT(Why("the robot asked: "),
              Contains("unknown are: In(bolt_1, hole_1)"));
}

TEST_F(ExplainedBench, AQuestionAboutWhatNobodyHasShownSaysThatNoRuleHasIt) {
  bench_ = BenchDomain(BenchWith("effects: [Closed(X)]", "effects: []"));
  Begin("done");
  Step(80);
  EXPECT_THAT(Why("the robot asked: please show me"),
              Contains("no rule (version 1) has an outcome with Closed(lid): "
                       "nobody has shown it"));
}

TEST_F(ExplainedBench, WhatIsLittleKnownIsTriedIfTheCellLearns) {
  const auto experiences = std::make_shared<std::vector<TaskExperience>>();
  params_.exploration = Exploration{.known_count = 2,
                                    .needs_confirmation = false,
                                    .experiences = experiences};
  std::vector<::cell::Action> actions = bench_.rules->actions();
  for (::cell::Action& action : actions) {
    if (action.name != "Insert") continue;
    for (NdrRule& rule : action.rules) rule.num_experiences = 1;
  }
  bench_.rules = std::make_shared<RuleSet>(
      "bench", 5, bench_.rules->shared_vocabulary(), actions);
  Begin("done");
  Step(10);
  const Reasons why = Why(kInsertBolt1);
  EXPECT_THAT(why[0], StartsWith("the cell learns, and knows little of it"));
  EXPECT_THAT(why, Contains("by this rule (version 5, learned from 1 "
                            "experience):"));
}

TEST_F(ExplainedBench, TheEndIsExplainedByTheGoal) {
  is_true_ = {"Closed(lid)"};
  Begin("done");
  Step(10);
  EXPECT_THAT(Why("the left arm was asked to go_home()"),
              ElementsAre(HasSubstr("'done' is reached")));
}

/// A person who assembles, is watched, and makes mistakes.
class ExplainedPerson : public testing::Test {
 protected:
  ExplainedPerson() : observer_(explainer_.Observer()) { Sense(); }

  void Decide(const Decisions& decisions) {
    if (!decisions.plan && decisions.alerts.empty()) return;
    observer_({utime(), 0}, decisions, watch_.Basis());
  }
  int64_t utime() const { return frame_ * 1'000'000; }
  void Sense() {
    ++frame_;
    Decide(watch_.OnSensed({frame_, utime(), state_}));
  }
  void Place(const std::string& name, const std::vector<std::string>& objects) {
    const GroundAction action =
        cranfield_.rules->FindGroundAction(name, objects).value();
    Do(action, cranfield_.Do(state_, action));
  }
  /// The action changes the state to this one.
  void Do(const GroundAction& action, const State& after) {
    Sense();
    const int64_t pick = frame_;
    state_ = after;
    Sense();
    Decide(watch_.OnAction({pick, utime(), pick, frame_, action.arguments,
                            cranfield_.rules->Show(action)}));
  }
  /// Of the warning at this moment.
  Reasons WhyWarned() const {
    for (const Explanation& explanation : explainer_.At(utime())) {
      if (explanation.what.starts_with("it was warned: ")) {
        return explanation.reasons;
      }
    }
    std::string all;
    for (const Explanation& explanation : explainer_.At(utime())) {
      all += explanation.what + "\n";
    }
    ADD_FAILURE() << "no warning, but: " << all;
    return {};
  }

  Cranfield cranfield_;
  Watch watch_{cranfield_.rules,
               cranfield_.domain->goals(),
               *cranfield_.domain->FindGoal("assembled"),
               PlanSearch::Maker({}),
               {},
               false};
  DecisionExplainer explainer_{false};
  DecisionObserver observer_;
  State state_ = cranfield_.Start();
  int64_t frame_ = -1;
};

TEST_F(ExplainedPerson, ThePlanIsExplainedByItsFirstStep) {
  const auto all = explainer_.At(utime());
  ASSERT_EQ(all.size(), 1u);
  EXPECT_THAT(all[0].what, StartsWith("this was the plan for the person (key "
                                      "frame 0): "));
  EXPECT_THAT(all[0].reasons, Contains(StartsWith("  Action: ")));
  EXPECT_THAT(all[0].reasons, Contains(StartsWith("next best: ")));
}

TEST_F(ExplainedPerson, AMistakeIsExplainedByTheStepsItAdds) {
  State after = cranfield_.With(state_, {"SeparatorPlaced(separator)"});
  after = cranfield_.With(after, {"Free(base.square_1)", "Free(base.square_2)"},
                          Truth::kFalse);
  Do(cranfield_.rules->FindGroundAction("PlaceSeparator", {"separator"})
         .value(),
     after);
  const Reasons why = WhyWarned();
  EXPECT_THAT(why, Contains(AllOf(StartsWith("it has changed: "),
                                  HasSubstr("SeparatorPlaced(separator)"))));
  EXPECT_THAT(why, Contains(AllOf(StartsWith("without it: "),
                                  HasSubstr("actions expected: "))));
  EXPECT_THAT(why, Contains(AllOf(StartsWith("after it: "),
                                  HasSubstr("RemoveSeparator(separator)"))));
  // What was needed all along is not named.
  EXPECT_THAT(why, Contains(AllOf(StartsWith("now necessary besides: "
                                             "RemoveSeparator(separator), "
                                             "since PlaceSquarePeg("),
                                  HasSubstr(" needs "))));
  EXPECT_THAT(why, Not(Contains(HasSubstr("besides: PlaceSquarePeg"))));
}

TEST_F(ExplainedPerson, AStepIsExplainedByWhatNeedsItFirst) {
  Place("PlaceRoundPeg", {"round_peg_1", "base.round_1"});
  Place("RemoveRoundPeg", {"round_peg_1", "base.round_1"});
  EXPECT_THAT(WhyWarned(),
              Contains("now necessary besides: PlaceRoundPeg(round_peg_1, "
                       "base.round_1), since PlaceFacePlate(face_plate) needs "
                       "PegInHole(_, base.round_1)"));
}

TEST_F(ExplainedPerson, AStepThatOnlyTheGoalNeedsIsExplainedByTheGoal) {
  std::mt19937_64 random(1);
  for (const GroundAction& action : cranfield_.RandomOrder(random)) {
    state_ = cranfield_.Do(state_, action);
  }
  Sense();  // before it is picked up
  Place("RemoveFacePlate", {"face_plate"});
  EXPECT_THAT(WhyWarned(),
              Contains("now necessary besides: PlaceFacePlate(face_plate), "
                       "since the goal needs "
                       "FacePlateFrontPlaced(face_plate)"));
}

TEST(ExplainedDeadEnd, IsExplainedByTheExcuse) {
  BenchDomain bench(
      BenchWith("context: [\"In(_, hole_1)\", \"In(_, "
                "hole_2)\", not Closed(X)]",
                "context: [not Closed(X)]"));
  Watch watch(bench.rules, bench.domain.goals(), bench.GoalOf("one"),
              PlanSearch::Maker({}), {}, false);
  DecisionExplainer explainer(false);
  const DecisionObserver observer = explainer.Observer();
  watch.OnSensed({0, 1'000'000, bench.StateOf({})});
  watch.OnSensed({1, 2'000'000, bench.StateOf({"Closed(lid)"})});
  observer(
      {2'000'000, 0},
      watch.OnAction({0, 2'000'000, 1, 1, {bench.Object("lid")}, "Close(lid)"}),
      watch.Basis());
  const auto all = explainer.At(2'000'000);
  ASSERT_FALSE(all.empty());
  EXPECT_THAT(all[0].what, StartsWith("it was warned: After Close(lid) no plan "
                                      "leads to the goal"));
  EXPECT_THAT(all[0].reasons, Contains("it has changed: Closed(lid)"));
  EXPECT_THAT(all[0].reasons, Contains("needed: not Closed(lid)"));
  EXPECT_THAT(all[0].reasons,
              Contains(StartsWith("Insert(bolt_1, hole_1) has this "
                                  "precondition in this rule")));
}

}  // namespace
}  // namespace cell
