// What the library says of actions replaces what recogniser and planner know,
// while they run.
#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cell/alert_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/library_request_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/sense_request_t.hpp"
#include "common/actions/action_model_writer.h"
#include "common/actions/record_messages.h"
#include "common/bus/stepper.h"
#include "services/planner/planner.h"
#include "services/recognizer/recognizer.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kHand = "hand_right";

template <class M>
std::vector<M> On(const std::string& channel,
                  const std::vector<Message>& messages) {
  std::vector<M> decoded;
  for (const Message& message : messages) {
    if (message.channel != channel) continue;
    EXPECT_GT(
        decoded.emplace_back().decode(message.bytes->data(), 0,
                                      static_cast<int>(message.bytes->size())),
        0);
  }
  return decoded;
}

/// A service of the shipped task, alone on a stepper.
class Alone {
 public:
  template <class Maker>
  Alone(const std::string& name, Maker make)
      : stepper_({.name = name}),
        service_(make(stepper_, ShippedDeployment())) {}

  template <class M>
  void Give(const std::string& channel, M message) {
    message.header.seq = next_seq_++;
    inputs_.push_back(*MessageFromWire(channel, Bus::Encode(message)));
  }
  void GiveEpisode(int8_t phase) {
    episode_t episode{};
    episode.phase = phase;
    episode.goal = "assembled";
    episode.agent = "person";
    Give("EPISODE", episode);
  }
  std::vector<Message> Run() {
    EXPECT_EQ(stepper_.Accept(++tick_, std::exchange(inputs_, {})),
              Stepper::State::kReady);
    return stepper_.Run();
  }
  /// In a tick of its own.
  std::vector<Message> Take(const ActionRecord& record) {
    Give("ACTION_RECORD", ToMessage(record));
    return Run();
  }

 private:
  Stepper stepper_;
  std::unique_ptr<Service> service_;
  std::vector<Message> inputs_;
  int32_t tick_ = 0;
  int32_t next_seq_ = 1;
};

class ActionRecords : public testing::Test {
 protected:
  ActionRecord Of(const std::string& action) const {
    const auto place = static_cast<size_t>(*task_.domain.FindAction(action));
    return WriteActionModel(task_.actions[place], task_.domain);
  }
  /// The same with another text in place of `from`, as the next version.
  static ActionRecord Changed(ActionRecord record,
                              std::string ActionRecord::*text,
                              const std::string& from, const std::string& to) {
    ++record.version;
    std::string& changed = record.*text;
    size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << changed;
    for (; at != std::string::npos; at = changed.find(from, at + to.size())) {
      changed.replace(at, from.size(), to);
    }
    return record;
  }

  /// The state at the start, known throughout.
  predicates_t Predicates() {
    predicates_t message{};
    const State state =
        task_.MakeSensor()->Sense(SceneOf(stage_.Frame(), task_.scene_objects));
    const Vocabulary& v = task_.domain.vocabulary();
    for (int i = 0; i < v.num_atoms(); ++i) {
      const GroundAtom atom = v.Atom(i);
      const auto& predicate =
          v.predicates()[static_cast<size_t>(atom.predicate)];
      if (predicate.report) continue;
      literal_t& literal = message.literals.emplace_back();
      literal.predicate = predicate.name;
      for (const int object : atom.objects) {
        literal.arguments.push_back(
            v.objects()[static_cast<size_t>(object)].name);
      }
      literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
      literal.value = static_cast<int8_t>(state.Get(i));
    }
    message.num_literals = static_cast<int32_t>(message.literals.size());
    return message;
  }
  /// What is recognised while the peg is taken and put on the table.
  std::vector<std::string> ActionsWhileMoving(Alone& service,
                                              const std::string& part,
                                              double x) {
    std::vector<std::string> names;
    const auto see = [&] {
      service.Give("KEY_FRAME", KeyFrameToMessage(stage_.Frame()));
      for (const auto& action :
           On<recognised_action_t>("ACTION", service.Run())) {
        names.push_back(action.name);
      }
    };
    see();
    stage_.Hold(kHand, part);
    see();
    stage_.StandAt(part, x, -0.7);
    stage_.LetGo(kHand, part);
    see();
    return names;
  }

  const ShippedTask task_;
  Stage stage_{task_};
};

TEST_F(ActionRecords, ThatSayWhatIsKnownChangeNothing) {
  Alone planner("planner", planner::MakePlanner);
  planner.GiveEpisode(episode_t::START);
  planner.Give("PREDICATES", Predicates());
  EXPECT_THAT(On<plan_t>("PLAN", planner.Run()), SizeIs(1));
  for (const ActionModel& model : task_.actions) {
    EXPECT_THAT(planner.Take(WriteActionModel(model, task_.domain)), IsEmpty())
        << model.action.name;
  }
}

TEST_F(ActionRecords, ReplaceTheRulesWhileThePlannerRuns) {
  Alone planner("planner", planner::MakePlanner);
  planner.GiveEpisode(episode_t::START);
  planner.Give("PREDICATES", Predicates());
  const auto before = On<plan_t>("PLAN", planner.Run());
  ASSERT_THAT(before, SizeIs(1));
  ActionModel model =
      task_.actions[static_cast<size_t>(*task_.domain.FindAction("ScrewHead"))];
  ++model.version;
  double probability = 0;
  for (NdrRule& rule : model.action.rules) {
    probability = rule.outcomes.at(0).probability;
    rule.outcomes[0].probability = rule.noise = 0.5;
  }
  const auto said = planner.Take(WriteActionModel(model, task_.domain));
  EXPECT_THAT(On<alert_t>("ALERT", said), IsEmpty());
  const auto after = On<plan_t>("PLAN", said);  // of the state as it is known
  ASSERT_THAT(after, SizeIs(1));
  EXPECT_NEAR(after[0].expected_actions - before[0].expected_actions,
              1 / 0.5 - 1 / probability, 1e-6);
}

TEST_F(ActionRecords, OfAnotherDomainAreRefusedInWords) {
  Alone planner("planner", planner::MakePlanner);
  planner.GiveEpisode(episode_t::START);
  planner.Run();
  const auto alerts = On<alert_t>(
      "ALERT", planner.Take(Changed(Of("ScrewHead"), &ActionRecord::rules,
                                    "HeadScrewed", "HatchClosed")));
  ASSERT_THAT(alerts, SizeIs(1));
  EXPECT_EQ(alerts[0].cause, alert_t::BAD_INPUT);
  EXPECT_THAT(alerts[0].text, HasSubstr("ACTION_RECORD ScrewHead:rules[0]"));
  EXPECT_THAT(alerts[0].text, HasSubstr("HatchClosed"));
}

TEST_F(ActionRecords, ReplaceWhatTheRecognizerKnows) {
  Alone recognizer("recognizer", recognizer::MakeRecognizer);
  recognizer.GiveEpisode(episode_t::START);
  stage_.LieAt("round_peg_1", 0.1, -0.7);
  EXPECT_THAT(ActionsWhileMoving(recognizer, "round_peg_1", 0.1),
              ElementsAre("Raise"));
  ActionRecord record = Of("Raise");
  record.name = "SetUpright";
  EXPECT_THAT(recognizer.Take(record), IsEmpty());
  stage_.LieAt("round_peg_2", 0.2, -0.7);
  EXPECT_THAT(ActionsWhileMoving(recognizer, "round_peg_2", 0.2),
              ElementsAre("Raise", "SetUpright"));
  record.name = "Raise";
  record.version = 2;
  record.sec.clear();
  recognizer.Take(record);
  stage_.LieAt("round_peg_1", 0.1, -0.7);
  EXPECT_THAT(ActionsWhileMoving(recognizer, "round_peg_1", 0.1),
              ElementsAre("SetUpright"));
}

TEST_F(ActionRecords, AreAskedForByWhoJoinsAnEpisodeThatRuns) {
  Alone planner("planner", planner::MakePlanner);
  Alone recognizer("recognizer", recognizer::MakeRecognizer);
  for (Alone* service : {&planner, &recognizer}) {
    service->GiveEpisode(episode_t::RUNNING);
    EXPECT_THAT(On<library_request_t>("LIBRARY_REQUEST", service->Run()),
                SizeIs(1));
    service->GiveEpisode(episode_t::RUNNING);
    EXPECT_THAT(On<library_request_t>("LIBRARY_REQUEST", service->Run()),
                IsEmpty());
  }
}

}  // namespace
}  // namespace cell
