// What a run prints on the screen.
#include "services/cell/reporting/narrator.h"

#include <gmock/gmock.h>

#include "cell/execution_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "common/bus/bus.h"

namespace cell::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

template <class T>
Message MessageOf(const std::string& channel, const T& content) {
  Message message{};
  message.channel = channel;
  message.bytes = std::make_shared<const Bytes>(Bus::Encode(content));
  return message;
}

plan_t PlanOf(const std::vector<std::string>& actions) {
  plan_t plan{};
  plan.result = actions.empty() ? plan_t::GOAL_REACHED : plan_t::FOUND;
  plan.expected_actions = static_cast<double>(actions.size());
  for (const std::string& action : actions) {
    plan_step_t step{};
    step.action = action;
    plan.steps.push_back(step);
    plan.next.push_back(step);
  }
  plan.num_steps = static_cast<int32_t>(plan.steps.size());
  plan.num_next = static_cast<int32_t>(plan.next.size());
  return plan;
}

std::vector<std::string> Trimmed(std::vector<std::string> lines) {
  for (std::string& line : lines) line.erase(0, line.find_first_not_of(' '));
  return lines;
}

TEST(Narrator, PrintsTheNextStepAndHowManyFollow) {
  Narrator narrator;
  const auto tell = [&](const std::vector<std::string>& actions) {
    return Trimmed(narrator.Describe(MessageOf("PLAN", PlanOf(actions))));
  };
  EXPECT_THAT(tell({"A", "B", "C"}),
              ElementsAre("next: A(), then 2 more steps"));
  EXPECT_THAT(tell({"A", "B", "C"}), IsEmpty()) << "nothing has changed";
  EXPECT_THAT(tell({"B", "C"}), ElementsAre("next: B(), then 1 more step"));
  EXPECT_THAT(tell({"C"}), ElementsAre("next: C(), the last step"));
  EXPECT_THAT(tell({}), ElementsAre("the goal is reached"));
}

TEST(Narrator, PrintsWholePlansOnRequestOnly) {
  Narrator narrator(true);
  EXPECT_THAT(Trimmed(narrator.Describe(MessageOf("PLAN", PlanOf({"A", "B"})))),
              ElementsAre("next: A(), then 1 more step",
                          "plan, 2.00 actions expected: A(), B()",
                          "possible now: A(), B()"));
}

TEST(Narrator, PrintsChangesNotTheWholeState) {
  predicates_t predicates{};
  for (const char* name : {"Calm", "Open"}) {
    literal_t literal{};
    literal.predicate = name;
    literal.value = literal_t::TRUE_;
    predicates.literals.push_back(literal);
  }
  predicates.num_literals = 2;
  Narrator brief, verbose(true);
  EXPECT_THAT(brief.Describe(MessageOf("PREDICATES", predicates)), IsEmpty());
  EXPECT_THAT(Trimmed(verbose.Describe(MessageOf("PREDICATES", predicates))),
              ElementsAre("state: Calm(), Open()"));
  predicates.literals[1].value = literal_t::FALSE_;
  EXPECT_THAT(Trimmed(brief.Describe(MessageOf("PREDICATES", predicates))),
              ElementsAre("now: not Open()"));
}

TEST(Narrator, PrintsTheConfidenceInAnActionOnRequestOnly) {
  recognised_action_t action{};
  action.kind = recognised_action_t::FORWARD;
  action.name = "Insert";
  action.arguments = {"bolt"};
  action.num_arguments = 1;
  action.hands = {"hand"};
  action.num_hands = 1;
  action.confidence = 0.876;
  Narrator brief, verbose(true);
  EXPECT_THAT(brief.Describe(MessageOf("ACTION", action)),
              ElementsAre(HasSubstr("recognised Insert(bolt) by hand")));
  EXPECT_THAT(brief.Describe(MessageOf("ACTION", action))[0],
              testing::Not(HasSubstr("0.88")));
  EXPECT_THAT(verbose.Describe(MessageOf("ACTION", action))[0],
              HasSubstr("by hand, confidence 0.88"));
}

TEST(Narrator, SaysWhatAnUnknownManipulationHasTaught) {
  recognised_action_t action{};
  action.kind = recognised_action_t::UNKNOWN;
  action.part = "bolt";
  Narrator narrator;
  EXPECT_THAT(narrator.Describe(MessageOf("ACTION", action)),
              ElementsAre(AllOf(HasSubstr("an unknown manipulation of bolt"),
                                testing::Not(HasSubstr("learned")))));
  action.name = "Action1";
  action.arguments = {"bolt", "hole"};
  action.num_arguments = 2;
  EXPECT_THAT(narrator.Describe(MessageOf("ACTION", action)),
              ElementsAre(HasSubstr("learned as Action1(bolt, hole)")));
}

TEST(Narrator, PrintsTheFormulaOfAQuestionOnRequestOnly) {
  execution_t execution{};
  execution.state = execution_t::STUCK;
  execution.text = "please put the shaft back";
  execution.formula = "Free(base.shaft) is false";
  Narrator brief, verbose(true);
  const auto lines = brief.Describe(MessageOf("EXECUTION", execution));
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_THAT(lines[0], HasSubstr("QUESTION: please put the shaft back"));
  EXPECT_THAT(verbose.Describe(MessageOf("EXECUTION", execution))[1],
              HasSubstr("because Free(base.shaft) is false"));
}

}  // namespace
}  // namespace cell::cli
