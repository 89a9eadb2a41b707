#include "common/rexd/ppddl_import.h"

#include <gmock/gmock.h>

#include "common/planning/ground_model.h"
#include "common/planning/ground_ppddl.h"
#include "common/planning/planner.h"
#include "common/ppddl/ppddl_error.h"
#include "common/ppddl/problem.h"
#include "common/rexd/rexd_task.h"
#include "common/rexd/rule_model.h"
#include "common/rules/ppddl_export.h"
#include "common/rules/rule_text.h"
#include "tests/unit/small_ppddl.h"

namespace cell::rexd {
namespace {

using testing::HasSubstr;

planning::Plan PlanOfPpddl(const std::string& domain_text,
                           const std::string& problem_text) {
  const auto domain = ppddl::ParseDomain(domain_text, "d");
  const auto problem = ppddl::ParseProblem(problem_text, "p", domain);
  const auto task = planning::GroundPpddl(domain, problem);
  const auto model = std::make_shared<planning::GroundModel>(*task);
  return planning::Planner(model, {}).Find(model->initial());
}

planning::Plan PlanOfTask(const RexdTask& task) {
  const auto model = std::make_shared<RuleModel>(
      task.truth, task, GroundActs(*task.world, task.initial));
  return planning::Planner(model, {}).Find(model->Pack(task.initial));
}

void ExpectSameValues(const planning::Plan& a, const planning::Plan& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_NEAR(a.probability.low, b.probability.low, 1e-9);
  EXPECT_NEAR(a.expected_actions, b.expected_actions, 1e-6);
}

TEST(PpddlImport, GivesTheSameValues) {
  for (const std::string& problem :
       {std::string(kDelivery), With(kDelivery, "(bridge m t)",
                                     "(bridge m t) (road m t) (bridge t m)")}) {
    const RexdTask task =
        ParseRexdTask(TaskOfPpddl({kCourier, "d"}, {problem, "p"}), "imported");
    ExpectSameValues(PlanOfTask(task), PlanOfPpddl(kCourier, problem));
  }
}

TEST(PpddlImport, WritesObjectsAsOneWord) {
  const std::string problem =
      With(With(With(kDelivery, "m t - town", "m l-1 - town"), "(bridge m t)",
                "(bridge m l-1)"),
           "(in x t)", "(in x l-1)");
  const RexdTask task =
      ParseRexdTask(TaskOfPpddl({kCourier, "d"}, {problem, "p"}), "imported");
  EXPECT_TRUE(task.world->FindObject("l_1"));
  ExpectSameValues(PlanOfTask(task), PlanOfPpddl(kCourier, problem));
  // Two objects would have one name.
  EXPECT_THROW(
      TaskOfPpddl({kCourier, "d"}, {With(problem, "m l-1", "m l_1 l-1"), "p"}),
      ppddl::PpddlError);
}

TEST(PpddlImport, WritesTypesQuantifiersAndWhatIsLeftOfProbability) {
  const std::string text = RulesOfPpddl({R"((define (domain d)
  (:types block)
  (:predicates (on ?a ?b - block) (held ?a - block) (free))
  (:action pick-up :parameters (?b1 - block)
    :precondition (and (free) (not (exists (?o - block) (on ?o ?b1)))
                       (forall (?o - block) (not (held ?o))))
    :effect (probabilistic 1/4 (and (held ?b1) (not (free)))))))",
                                         "d"});
  EXPECT_EQ(text, R"(block 1 primitive
on 2 primitive
held 1 primitive
free 0 primitive
pick-up 1 action <-- block(X)

Action: pick-up(B1)
Preconditions: free(), not on(_, B1), not held(_)
Effects:
  0.25: not free(), held(B1)
  0.75: nothing
  0: noise
)");
  rules::ParseRules(text, "imported");  // is readable
}

TEST(PpddlImport, ReadsWhatRulesAreExportedAs) {
  // Out, in, and out again: the same PPDDL, with references and quantifiers.
  const rules::NdrRules rules = rules::ParseRules(R"(
shelf 0 constant
on 2 primitive
held 1 primitive
lift 1 action
drop 1 action

Action: lift(X)
References: Y: on(X, Y)
Preconditions: not held(_), Y != shelf
Effects:
  0.75: not on(X, Y), held(X)
  0.25: nothing
  0: noise

Action: drop(X)
Preconditions: held(X)
Effects:
  1: not held(X), on(X, shelf)
  0: noise
)",
                                                  "r");
  const std::string written = *rules::ToPpddl(rules, "d");
  const rules::NdrRules again =
      rules::ParseRules(RulesOfPpddl({written, "d"}), "imported");
  EXPECT_EQ(rules::ToText(again), rules::ToText(rules));
  EXPECT_EQ(*rules::ToPpddl(again, "d"), written);
}

struct Unsupported {
  const char* old_text;
  const char* new_text;
  const char* message;
};

TEST(PpddlImport, NamesWhatRulesHaveNoWordsForWithLineAndColumn) {
  for (const Unsupported& c : {
           Unsupported{":effect (and (in ?x ?p)",
                       ":effect (and (when (broken) (in ?x ?p))",
                       "d:19:18: rules have no conditional effects"},
           {":precondition (and (at ?p) (loaded ?x))",
            ":precondition (or (at ?p) (loaded ?x))",
            "d:18:19: rules have no words for 'or'"},
           {"(broken)", "(broken) (four ?a ?b ?c ?d)",
            "'four' has 4 arguments; rules have at most 3"},
           {"(broken)", "(broken) (place)", "'place' is used for something"},
       }) {
    try {
      RulesOfPpddl({With(kCourier, c.old_text, c.new_text), "d"});
      ADD_FAILURE() << c.message;
    } catch (const ppddl::PpddlError& error) {
      EXPECT_THAT(error.what(), HasSubstr(c.message));
    }
  }
  EXPECT_THROW(
      TaskOfPpddl({kCourier, "d"}, {With(kDelivery, "(:goal (in x t))",
                                         "(:goal (or (in x t) (in x m)))"),
                                    "p"}),
      ppddl::PpddlError);
}

}  // namespace
}  // namespace cell::rexd
