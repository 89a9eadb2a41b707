#include "common/rules/ppddl_export.h"

#include <gmock/gmock.h>

#include "common/rules/rule_text.h"

namespace cell::rules {
namespace {

using testing::HasSubstr;

TEST(PpddlExport, WritesReferencesQuantifiersAndDerivedPredicates) {
  const NdrRules rules = ParseRules(R"(
shelf.top 0 constant
cup 1 primitive
on 2 primitive
held 1 primitive
weight 1 primitive integers
lift 1 action <-- cup(X)
clear 1 conjunction <-- All Y -on(Y X)
above 2 transclosure <-- + on

Action: lift(X)
References: Y: on(X, Y)
Preconditions: not held(_), weight(X) <= 4, Y != shelf.top, clear(X)
Effects:
  0.75: held(X), not on(X, Y), weight(X) = 0
  0.25: noise

Action: lift(X)
Preconditions: held(X)
Effects:
  1: noise
)",
                                    "r");
  const auto text = ToPpddl(rules, "cups");
  ASSERT_TRUE(text) << text.reason();
  EXPECT_EQ(*text, R"((define (domain cups)
  (:requirements :adl :probabilistic-effects :derived-predicates :fluents)
  (:constants shelf-top)
  (:predicates (cup ?x) (on ?x ?y) (held ?x) (clear ?x) (above ?x ?y))
  (:functions (weight ?x))
  (:derived (clear ?x)
    (forall (?y) (and (not (on ?y ?x)))))
  (:derived (above ?x ?y)
    (or (on ?x ?y) (exists (?z) (and (on ?x ?z) (above ?z ?y)))))
  (:action lift
    :parameters (?x ?y)
    :precondition (and (and (cup ?x)) (on ?x ?y)
      (forall (?other) (imply (and (on ?x ?other)) (= ?other ?y))) (not (exists (?any1) (held ?any1))) (<= (weight ?x) 4) (not (= ?y shelf-top)) (clear ?x))
    :effect (probabilistic
      0.75 (and (held ?x) (not (on ?x ?y)) (assign (weight ?x) 0))))
  (:action lift_2
    :parameters (?x)
    :precondition (and (and (cup ?x)) (held ?x))
    :effect (and))
)
)");
}

TEST(PpddlExport, WritesChangesOfEachObjectAsConditionalEffects) {
  const NdrRules rules = ParseRules(
      "on 2 primitive\nclear 1 primitive\nput 2 action\n"
      "Action: put(X, Y)\nPreconditions: none\nEffects:\n"
      "  1: on(X, Y)\n    each P: not clear(P) if on(P, Y)\n  0: noise\n",
      "r");
  const auto text = ToPpddl(rules, "cups");
  ASSERT_TRUE(text) << text.reason();
  EXPECT_THAT(*text, HasSubstr("(forall (?p) (when (and (on ?p ?y)) "
                               "(not (clear ?p)))) (on ?x ?y))"));
}

TEST(PpddlExport, SaysWhatPpddlHasNoWordsFor) {
  const NdrRules counts = ParseRules(
      "lift 1 action\non 2 primitive\nheight 1 count <-- Num Y on(X Y)\n"
      "Action: lift(X)\nPreconditions: height(X) = 1\nEffects:\n  1: noise\n",
      "r");
  EXPECT_THAT(ToPpddl(counts, "d").reason(),
              HasSubstr("a rule asks for 'height', a count"));
  const NdrRules names = ParseRules("lift 1 action\nLift 1 primitive\n", "r");
  EXPECT_THAT(ToPpddl(names, "d").reason(), HasSubstr("'Lift'"));
}

}  // namespace
}  // namespace cell::rules
