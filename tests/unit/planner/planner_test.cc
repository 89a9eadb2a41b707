#include "services/planner/planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cell/alert_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/plan_t.hpp"
#include "common/bus/stepper.h"
#include "services/planner/planner_messages.h"
#include "tests/unit/cranfield_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::HasSubstr;
using testing::Not;

class PlannerService : public testing::Test {
 protected:
  PlannerService() { service_ = cranfield_.MakePlannerOfRules(stepper_); }

  template <class M>
  void Give(const std::string& channel, const M& message) {
    inputs_.push_back(*MessageFromWire(channel, Bus::Encode(message)));
  }
  /// Runs a tick on what was given; keeps what is published.
  void Run() {
    plans_.clear();
    alerts_.clear();
    num_asked_ = 0;
    if (stepper_.Accept(++tick_, std::move(inputs_)) ==
        Stepper::State::kReady) {
      for (const Message& m : stepper_.Run()) {
        if (m.channel == "PLAN") Decode(m, plans_.emplace_back());
        if (m.channel == "ALERT") Decode(m, alerts_.emplace_back());
        num_asked_ += m.channel == "SENSE_REQUEST";
      }
    }
    inputs_.clear();
  }
  template <class M>
  void Decode(const Message& message, M& decoded) {
    ASSERT_GT(decoded.decode(message.bytes->data(), 0,
                             static_cast<int>(message.bytes->size())),
              0);
  }

  void Start(const std::string& goal) {
    episode_t episode{};
    episode.phase = episode_t::START;
    episode.goal = goal;
    episode.agent = "person";
    Give("EPISODE", episode);
  }
  void Phase(int8_t phase) {
    episode_t episode{};
    episode.id = 1;
    episode.phase = phase;
    episode.goal = "assembled";
    episode.agent = "person";
    Give("EPISODE", episode);
  }
  /// Lets so many seconds pass; all alerts of causes UNSEEN on the way.
  std::string UnseenWithin(int seconds) {
    std::string texts;
    for (int i = 0; i < seconds * 125; ++i) {
      Run();
      for (const alert_t& alert : alerts_) {
        if (alert.cause == alert_t::UNSEEN) texts += alert.text + "\n";
      }
    }
    return texts;
  }
  State WithPegs(const std::vector<std::pair<std::string, std::string>>& pegs) {
    State state = cranfield_.Start();
    for (const auto& [peg, hole] : pegs) {
      state = cranfield_.Do(state, "PlaceRoundPeg", {peg, hole});
    }
    return state;
  }
  predicates_t Predicates(int64_t key_frame, const State& state) const {
    predicates_t message{};
    message.header.utime = key_frame * 1000;
    message.key_frame = key_frame;
    const Vocabulary& v = cranfield_.domain->vocabulary();
    for (int i = 0; i < v.num_atoms(); ++i) {
      literal_t& literal = message.literals.emplace_back();
      const GroundAtom atom = v.Atom(i);
      literal.predicate = v.predicates()[atom.predicate].name;
      for (const int object : atom.objects) {
        literal.arguments.push_back(v.objects()[object].name);
      }
      literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
      literal.value = static_cast<int8_t>(state.Get(i));
    }
    message.num_literals = static_cast<int32_t>(message.literals.size());
    return message;
  }
  static recognised_action_t PlaceShaft(int8_t kind, int64_t index,
                                        int64_t place) {
    recognised_action_t action{};
    action.header.utime = place * 1000;
    action.index = index;
    action.header.seq = static_cast<int32_t>(index);
    action.kind = kind;
    action.name = "PlaceRoundPeg";
    action.arguments = {"shaft", "base.shaft"};
    action.num_arguments = 2;
    action.part = "shaft";
    action.pick_key_frame = place - 1;
    action.place_key_frame = place;
    return action;
  }

  Cranfield cranfield_;
  Stepper stepper_{{.name = "planner"}};
  std::unique_ptr<Service> service_;
  std::vector<Message> inputs_;
  std::vector<plan_t> plans_;
  std::vector<alert_t> alerts_;
  int num_asked_ = 0;  // for the state
  int32_t tick_ = 0;
};

TEST_F(PlannerService, PlansFromTheFirstPredicatesOfAnEpisode) {
  Start("assembled");
  Give("PREDICATES", Predicates(3, cranfield_.Start()));
  Run();
  ASSERT_EQ(plans_.size(), 1u);
  EXPECT_EQ(plans_[0].result, plan_t::FOUND);
  EXPECT_EQ(plans_[0].key_frame, 3);
  EXPECT_EQ(plans_[0].header.utime, 3000);
  EXPECT_EQ(plans_[0].num_steps, 9);
  EXPECT_NEAR(plans_[0].expected_actions, 9 / 0.95, 1e-8);
}

TEST_F(PlannerService, PlansAfterAnActionAndWarnsOfItsReversal) {
  const State placed = cranfield_.Do(cranfield_.Start(), "PlaceRoundPeg",
                                     {"shaft", "base.shaft"});
  Start("assembled");
  Give("PREDICATES", Predicates(0, cranfield_.Start()));
  Run();
  Give("ACTION", PlaceShaft(recognised_action_t::FORWARD, 0, 2));
  Give("PREDICATES", Predicates(2, placed));
  Run();
  ASSERT_EQ(plans_.size(), 1u);
  EXPECT_NEAR(plans_[0].expected_actions, 8 / 0.95, 1e-8);
  EXPECT_TRUE(alerts_.empty());
  Give("ACTION", PlaceShaft(recognised_action_t::REVERSED, 1, 4));
  Give("PREDICATES", Predicates(4, cranfield_.Start()));
  Run();
  ASSERT_EQ(alerts_.size(), 1u);
  EXPECT_EQ(alerts_[0].level, alert_t::WARNING);
  EXPECT_EQ(alerts_[0].cause, alert_t::LONGER_PLAN);
  EXPECT_EQ(alerts_[0].header.utime, 4000);
  EXPECT_THAT(alerts_[0].text,
              HasSubstr("taking back PlaceRoundPeg(shaft, base.shaft)"));
}

TEST_F(PlannerService, AGoalThatIsNotThereIsSaidAndNotPlannedFor) {
  Start("assembeld");
  Give("PREDICATES", Predicates(0, cranfield_.Start()));
  Run();
  ASSERT_EQ(alerts_.size(), 1u);
  EXPECT_EQ(alerts_[0].cause, alert_t::BAD_INPUT);
  EXPECT_THAT(alerts_[0].text, HasSubstr("assembled"));
  EXPECT_TRUE(plans_.empty());
}

TEST_F(PlannerService, ANewEpisodeStartsAfresh) {
  Start("assembled");
  Give("PREDICATES", Predicates(0, cranfield_.Start()));
  Run();
  Start("round_pegs");
  Give("PREDICATES", Predicates(0, cranfield_.Start()));
  Run();
  ASSERT_EQ(plans_.size(), 1u);
  EXPECT_EQ(plans_[0].num_steps, 2);
}

TEST_F(PlannerService, ALifeWithinAnEpisodeTellsWhatItFindsDone) {
  Phase(episode_t::RUNNING);
  Run();
  EXPECT_EQ(num_asked_, 1);  // there may be no further key frame
  Give("PREDICATES", Predicates(3, WithPegs({{"shaft", "base.shaft"}})));
  const std::string told = UnseenWithin(30);
  EXPECT_THAT(told, HasSubstr("PegInHole(shaft, base.shaft)"));
  EXPECT_THAT(told, Not(HasSubstr("round")));
}

TEST_F(PlannerService, ALifeWithinAnEpisodeAsksUntilItIsToldTheState) {
  Phase(episode_t::RUNNING);
  int num_asked = 0;
  for (int i = 0; i < 500; ++i) {
    Run();
    num_asked += num_asked_;
  }
  EXPECT_GE(num_asked, 4);
  Give("PREDICATES", Predicates(3, cranfield_.Start()));
  Run();
  num_asked = 0;
  for (int i = 0; i < 500; ++i) {
    Run();
    num_asked += num_asked_;
  }
  EXPECT_EQ(num_asked, 0);
}

TEST_F(PlannerService, AnActionAccountsForItsOwnPlacementAlone) {
  Start("assembled");
  Give("PREDICATES", Predicates(0, cranfield_.Start()));
  Run();
  Give("PREDICATES",
       Predicates(2, WithPegs({{"shaft", "base.shaft"},
                               {"round_peg_1", "base.round_1"}})));
  Give("ACTION", PlaceShaft(recognised_action_t::FORWARD, 0, 2));
  const std::string told = UnseenWithin(30);
  EXPECT_THAT(told, HasSubstr("PegInHole(round_peg_1, base.round_1)"));
  EXPECT_THAT(told, Not(HasSubstr("PegInHole(shaft")));
}

TEST_F(PlannerService, WhatWaitsForAnActionOutlivesAnotherGoal) {
  Start("assembled");
  Give("PREDICATES", Predicates(0, cranfield_.Start()));
  Run();
  Give("PREDICATES", Predicates(2, WithPegs({{"shaft", "base.shaft"}})));
  Run();
  command_goal_t goal{};
  goal.goal = "round_pegs";
  goal.deadline_utime = 1'000'000;
  Give("COMMAND_GOAL", goal);
  EXPECT_THAT(UnseenWithin(30), HasSubstr("PegInHole(shaft, base.shaft)"));
}

TEST_F(PlannerService, WhatWaitsForAnActionIsToldWhenTheEpisodeIsOver) {
  Start("assembled");
  Give("PREDICATES", Predicates(0, cranfield_.Start()));
  Run();
  Give("PREDICATES", Predicates(2, WithPegs({{"shaft", "base.shaft"}})));
  Phase(episode_t::END);
  EXPECT_THAT(UnseenWithin(1), HasSubstr("PegInHole(shaft, base.shaft)"));
}

TEST_F(PlannerService, RejectsWhatTheDomainDoesNotKnow) {
  const RuleSet& rules = *cranfield_.rules;
  const Vocabulary& vocabulary = rules.vocabulary();
  const predicates_t good = Predicates(0, cranfield_.Start());
  ASSERT_TRUE(FromMessage(good, vocabulary).has_value());
  predicates_t bad = good;
  bad.literals[0].predicate = "Shiny";
  EXPECT_FALSE(FromMessage(bad, vocabulary).has_value());
  bad = good;
  bad.literals[0].value = 3;
  EXPECT_FALSE(FromMessage(bad, vocabulary).has_value());
  bad = good;
  bad.literals[0].arguments[0] = "base.round_1";
  EXPECT_FALSE(FromMessage(bad, vocabulary).has_value());
  bad = good;
  bad.literals[0].arguments.push_back("head");
  EXPECT_FALSE(FromMessage(bad, vocabulary).has_value());
  bad = good;
  bad.literals[1] = bad.literals[0];
  EXPECT_FALSE(FromMessage(bad, vocabulary).has_value());
  bad = good;
  bad.key_frame = -1;
  EXPECT_FALSE(FromMessage(bad, vocabulary).has_value());

  const recognised_action_t action =
      PlaceShaft(recognised_action_t::FORWARD, 0, 2);
  ASSERT_TRUE(FromMessage(action, rules).has_value());
  recognised_action_t wrong = action;
  wrong.kind = 3;
  EXPECT_FALSE(FromMessage(wrong, rules).has_value());
  wrong = action;
  wrong.part = "spoon";
  EXPECT_FALSE(FromMessage(wrong, rules).has_value());
  wrong = action;
  wrong.arguments.pop_back();
  EXPECT_FALSE(FromMessage(wrong, rules).has_value());
  wrong = action;
  wrong.pick_key_frame = 5;
  EXPECT_FALSE(FromMessage(wrong, rules).has_value());
}

TEST_F(PlannerService, WhatIsNotListedIsUnknown) {
  predicates_t message = Predicates(0, cranfield_.Start());
  message.literals.pop_back();
  const auto sensed = FromMessage(message, cranfield_.rules->vocabulary());
  ASSERT_TRUE(sensed.has_value());
  EXPECT_EQ(sensed->state.UnknownAtoms(),
            std::vector<int>{sensed->state.num_atoms() - 1});
}

TEST_F(PlannerService, SameInputsSameBytes) {
  const auto run = [this] {
    Stepper stepper({.name = "planner"});
    const auto service = MakePlanner(
        stepper, Deployment{CELL_SOURCE_DIR "/deploy/config",
                            CELL_SOURCE_DIR "/deploy/tasks/cranfield",
                            {}});
    episode_t episode{};
    episode.goal = "assembled";
    episode.agent = "person";
    std::vector<Message> inputs = {
        *MessageFromWire("EPISODE", Bus::Encode(episode)),
        *MessageFromWire("PREDICATES",
                         Bus::Encode(Predicates(0, cranfield_.Start())))};
    stepper.Accept(1, inputs);
    return *stepper.Run().at(0).bytes;
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace cell
