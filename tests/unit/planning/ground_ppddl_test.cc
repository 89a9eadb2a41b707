#include "common/planning/ground_ppddl.h"

#include <gmock/gmock.h>

#include <set>
#include <string>

#include "tests/unit/planning/ppddl_task.h"
#include "tests/unit/small_ppddl.h"

namespace cell::planning {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::UnorderedElementsAre;

std::set<std::string> NamesOf(const GroundTask& task) {
  std::set<std::string> names;
  for (const GroundAction& action : task.actions) names.insert(action.name);
  return names;
}

std::set<std::string> AtomNamesOf(const GroundTask& task) {
  std::set<std::string> names;
  for (const GroundAtom& atom : task.atoms) names.insert(Show(atom));
  return names;
}

TEST(GroundPpddl, OnlyWhatCanApplyIsKept) {
  const GroundTask task = TaskOf(kCourier, kDelivery);
  EXPECT_THAT(
      NamesOf(task),
      UnorderedElementsAre("drive(depot, m)", "drive(m, depot)", "cross(m, t)",
                           "load(x, depot)", "load(x, m)", "load(x, t)",
                           "unload(x, depot)", "unload(x, m)", "unload(x, t)"));
  EXPECT_THAT(AtomNamesOf(task),
              UnorderedElementsAre("at(depot)", "at(m)", "at(t)", "broken()",
                                   "in(x, depot)", "in(x, m)", "in(x, t)",
                                   "loaded(x)"));
}

TEST(GroundPpddl, ConstantAtomsCanBeKept) {
  const GroundTask task = TaskOf(kCourier, kDelivery, ConstantAtoms::kKeep);
  EXPECT_THAT(AtomNamesOf(task), testing::Contains("road(m, t)"));
  EXPECT_THAT(NamesOf(task), testing::Contains("drive(m, t)"));
}

TEST(GroundPpddl, QuantifiersRunOverTheObjectsOfTheirTypes) {
  const std::string domain =
      "(define (domain d) (:types a b) (:predicates (p ?x - a) (q ?x - b)) "
      "(:action all :precondition (forall (?x - a) (p ?x)) "
      "  :effect (forall (?y - b) (q ?y))))";
  const GroundTask task =
      TaskOf(domain,
             "(define (problem p) (:domain d) (:objects a1 a2 - a b1 b2 - b) "
             "(:init (p a1) (p a2)) (:goal (forall (?y - b) (q ?y))))");
  ASSERT_THAT(task.actions, SizeIs(1));
  EXPECT_EQ(task.actions[0].precondition, Conjunction{}) << "always true";
  EXPECT_EQ(PlanOf(task).probability.low, 1);
}

TEST(GroundPpddl, DisjunctionsBecomeClausesOrActions) {
  // Literals stay one action with a clause.
  const GroundTask clause =
      Propositional(4,
                    "(:action f :effect (probabilistic 0.5 (p0) 0.5 (p1)))"
                    "(:action g :precondition (or (p0) (p1)) :effect (p3))",
                    "", "(p3)");
  EXPECT_THAT(clause.actions, SizeIs(2));
  EXPECT_EQ(PlanOf(clause).probability.low, 1);
  // Conjunctions need several.
  const GroundTask several = Propositional(
      4,
      "(:action f :effect (probabilistic 0.5 (p0) 0.5 (p1)))"
      "(:action g :precondition (or (and (p0) (not (p1))) (and (p1) (not "
      "(p0)))) :effect (p3))",
      "", "(p3)");
  EXPECT_THAT(several.actions, SizeIs(3));
  EXPECT_EQ(PlanOf(several).probability.low, 1);
}

TEST(GroundPpddl, IndependentProbabilisticEffectsMultiply) {
  const GroundTask task =
      Propositional(3,
                    "(:action f :precondition (p2) :effect (and (not (p2)) "
                    "(probabilistic 0.5 (p0)) (probabilistic 0.25 (p1))))",
                    "(p2)", "(and (p0) (p1))");
  EXPECT_DOUBLE_EQ(PlanOf(task).probability.low, 0.125);
}

TEST(GroundPpddl, ConditionsAreThoseBeforeTheActionAndAdditionsCountLast) {
  const GroundTask task =
      Propositional(3,
                    "(:action f :effect (and (p0) (not (p0)) (when (p0) (p1)) "
                    "(when (not (p0)) (p2))))",
                    "", "(and (p0) (p1) (p2))");
  const Plan plan = PlanOf(task);
  EXPECT_EQ(plan.probability.low, 1);
  EXPECT_EQ(plan.expected_actions, 2) << "p2 at first, p1 the second time";
}

TEST(GroundPpddl, AnObjectOfAnotherTypeMakesNoAtom) {
  const GroundTask task = TaskOf(
      "(define (domain d) (:types a - object b - a) (:predicates (p ?x - b) "
      "(done)) (:action f :parameters (?x - a) :precondition (p ?x) :effect "
      "(done)))",
      "(define (problem p) (:domain d) (:objects u - a v - b) (:init (p v)) "
      "(:goal (done)))");
  EXPECT_THAT(NamesOf(task), UnorderedElementsAre("f(v)"));
}

TEST(GroundPpddl, TooLargeTasksAreRefusedWithTheReason) {
  std::string objects;
  for (int i = 0; i < 60; ++i) objects += " o" + std::to_string(i);
  const auto domain = ppddl::ParseDomain(
      "(define (domain d) (:predicates (p ?x) (q)) (:action f :parameters (?a "
      "?b ?c ?d) :precondition (and (p ?a) (p ?b) (p ?c) (p ?d)) :effect (and "
      "(q) (not (p ?a)))) (:action g :effect (forall (?a) (probabilistic 0.5 "
      "(p ?a)))))",
      "d");
  const auto problem = ppddl::ParseProblem(
      "(define (problem p) (:domain d) (:objects" + objects + ") (:goal (q)))",
      "p", domain);
  EXPECT_THAT(
      GroundPpddl(domain, problem, ConstantAtoms::kReplace, {1000}).reason(),
      HasSubstr("more than 1000 ground actions, at f"));
  const auto few = ppddl::ParseProblem(
      "(define (problem p) (:domain d) (:objects a b c d e f g h i j k l m n) "
      "(:goal (q)))",
      "p", domain);
  EXPECT_THAT(GroundPpddl(domain, few).reason(),
              HasSubstr("g has more than 4096 outcomes"));
  // Nested quantifiers multiply.
  const auto nested = ppddl::ParseProblem(
      "(define (problem p) (:domain d) (:objects" + objects +
          ") (:goal (forall (?a) (exists (?b) (forall (?c) (exists (?d) "
          "(and (p ?a) (p ?b) (p ?c) (p ?d))))))))",
      "p", ppddl::ParseDomain("(define (domain d) (:predicates (p ?x)))", "d"));
  EXPECT_THAT(
      GroundPpddl(ppddl::ParseDomain("(define (domain d) (:predicates (p "
                                     "?x)))",
                                     "d"),
                  nested)
          .reason(),
      HasSubstr("the goal"));
}

}  // namespace
}  // namespace cell::planning
