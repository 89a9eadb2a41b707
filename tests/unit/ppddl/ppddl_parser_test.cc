#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/ppddl/expression.h"
#include "common/ppddl/problem.h"
#include "tests/unit/small_ppddl.h"

namespace cell::ppddl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// What the parser says of a domain's text; empty if it accepts it.
std::string DomainError(const std::string& text) {
  try {
    ParseDomain(text, "d.pddl");
  } catch (const PpddlError& error) {
    return error.what();
  }
  return "";
}

std::string ProblemError(const std::string& text) {
  try {
    ParseProblem(text, "p.pddl", ParseDomain(kCourier, "d.pddl"));
  } catch (const PpddlError& error) {
    return error.what();
  }
  return "";
}

TEST(PpddlParser, SkipsAByteOrderMark) {
  EXPECT_EQ(DomainError(std::string("\xef\xbb\xbf") + kCourier), "");
}

TEST(PpddlExpression, WordsAreLowerCaseAndCommentsAreSkipped) {
  const auto read = ReadExpressions("; (no)\n(A b ; c\n (D))", "f");
  ASSERT_EQ(read.size(), 1u);
  ASSERT_EQ(read[0].items.size(), 3u);
  EXPECT_EQ(read[0].items[0].word, "a");
  EXPECT_TRUE(read[0].items[2].is_list);
  EXPECT_EQ(read[0].items[2].line, 3);
  EXPECT_EQ(read[0].items[2].column, 2);
}

TEST(PpddlParser, NamesAreResolved) {
  const Domain domain = ParseDomain(kCourier, "d.pddl");
  EXPECT_EQ(domain.name, "courier");
  ASSERT_EQ(domain.types.size(), 4u);
  EXPECT_TRUE(domain.IsA(3, 1)) << "a town is a place";
  EXPECT_FALSE(domain.IsA(1, 3));
  ASSERT_EQ(domain.actions.size(), 4u);
  const Effect& load = domain.actions[2].effect;
  EXPECT_EQ(load.kind, Effect::Kind::kProbabilistic);
  EXPECT_THAT(load.probabilities, ElementsAre(0.5));
  EXPECT_THAT(domain.actions[1].effect.probabilities, ElementsAre(0.75, 0.25));

  const Problem problem = ParseProblem(kDelivery, "p.pddl", domain);
  EXPECT_EQ(problem.objects.size(), 3u);
  EXPECT_EQ(problem.init.size(), 5u);
  EXPECT_EQ(Show(problem.init[1], domain, problem), "in(x, depot)");
  ASSERT_TRUE(problem.metric.has_value());
  EXPECT_FALSE(problem.metric->is_maximized);
}

TEST(PpddlParser, AnActionNeedsNoParametersAndNoPrecondition) {
  const Domain domain = ParseDomain(
      "(define (domain d) (:predicates (p)) (:action a :effect (p)))", "d");
  EXPECT_TRUE(domain.actions[0].parameters.empty());
  EXPECT_EQ(domain.actions[0].precondition, Condition{});
}

TEST(PpddlParser, AnErrorNamesThePlaceAndWhatWouldBeRight) {
  EXPECT_THAT(DomainError(With(kCourier, "(not (broken))", "(not (brocken))")),
              AllOf(StartsWith("d.pddl:11:53: "), HasSubstr("'brocken'"),
                    HasSubstr("did you mean 'broken'?")));
  EXPECT_THAT(DomainError(With(kCourier, "(at ?b) (not", "(at ?c) (not")),
              AllOf(StartsWith("d.pddl:9:22: "), HasSubstr("'?c'")));
  EXPECT_THAT(DomainError(With(kCourier, "(at ?b) (not", "(at ?a ?b) (not")),
              HasSubstr("'at' takes 1 argument, not 2"));
  EXPECT_THAT(
      DomainError(With(kCourier, "(loaded ?x) (not", "(loaded ?p) (not")),
      HasSubstr("'?p' is of the type 'place', but 'loaded' takes"));
  EXPECT_THAT(DomainError(With(kCourier, ":precondition", ":preconditon")),
              HasSubstr("did you mean ':precondition'?"));
  EXPECT_THAT(ProblemError(With(kDelivery, "courier", "currier")),
              HasSubstr("not of 'courier'"));
  EXPECT_THAT(ProblemError(With(kDelivery, "(in x t)", "(in ?x t)")),
              HasSubstr("only objects are allowed"));
  EXPECT_THAT(ProblemError(With(kDelivery, "m t - town", "m m - town")),
              HasSubstr("two objects 'm'"));
  EXPECT_THAT(ProblemError(With(kDelivery, "(:goal (in x t))", "")),
              HasSubstr("(:goal ...) is missing"));
}

TEST(PpddlParser, ProbabilitiesAreChecked) {
  for (const auto& [bad, why] :
       {std::pair{"(probabilistic 1/2 (loaded ?x) 0.6 (broken))",
                  "they must not exceed 1"},
        {"(probabilistic 1/0 (loaded ?x))", "denominator 0"},
        {"(probabilistic -0.1 (loaded ?x))", "not between 0 and 1"},
        {"(probabilistic nan (loaded ?x))", "write 0.25 or 1/4"},
        {"(probabilistic 1e999 (loaded ?x))", "write 0.25 or 1/4"},
        {"(probabilistic (loaded ?x))", "write (probabilistic"}}) {
    EXPECT_THAT(
        DomainError(With(
            kCourier, "(probabilistic 1/2 (and (loaded ?x) (not (in ?x ?p))))",
            bad)),
        HasSubstr(why))
        << bad;
  }
}

TEST(PpddlParser, WhatIsNotSupportedIsNamed) {
  const auto with = [](const std::string& other) {
    return DomainError(With(kCourier, "(increase (total-cost) 1)", other));
  };
  EXPECT_THAT(with("(assign (total-cost) 1)"), HasSubstr("'assign'"));
  EXPECT_THAT(with("(oneof (broken))"), HasSubstr("'oneof'"));
  EXPECT_THAT(DomainError(With(kCourier, ":typing", ":durative-actions")),
              HasSubstr(":durative-actions is not supported"));
  EXPECT_THAT(DomainError(With(kCourier, ":typing", ":tipping")),
              HasSubstr("did you mean ':typing'?"));
  EXPECT_THAT(
      DomainError(With(kCourier, "(road ?a ?b))", "(> (total-cost) 3))")),
      HasSubstr("numeric conditions"));
  EXPECT_THAT(DomainError(With(kCourier, "?x - parcel ?p",
                               "?x - (either parcel town) ?p")),
              HasSubstr("(either ...)"));
  EXPECT_THAT(ProblemError(With(kDelivery, "(at depot)",
                                "(probabilistic 0.5 (at depot))")),
              HasSubstr("probabilistic initial state"));
}

TEST(PpddlParser, HostileTextIsRefused) {
  EXPECT_THAT(DomainError(std::string(100'000, '(')),
              HasSubstr("nested deeper than"));
  EXPECT_THAT(DomainError("(define (domain d)"), HasSubstr("never closed"));
  EXPECT_THAT(DomainError("(define (domain d)))"), HasSubstr("no list"));
  EXPECT_THAT(DomainError("(define (domain \x01))"), HasSubstr("\\x01"));
  EXPECT_THAT(DomainError(""), HasSubstr("defines no domain"));
  EXPECT_THAT(DomainError(std::string(5000, 'a')), HasSubstr("1000 bytes"));
  EXPECT_THAT(DomainError("(define (domain d) (:types a - b b - c c - a))"),
              HasSubstr("own ancestor"));
  EXPECT_THAT(DomainError("(define (domain d) (:types object - a))"),
              HasSubstr("'object' is the ancestor"));
}

// Every prefix and every text with a byte left out is accepted or refused with
// a place.
TEST(PpddlParser, DamagedTextGetsAnError) {
  const std::string text = kCourier;
  for (size_t i = 0; i < text.size(); ++i) {
    for (const std::string& damaged :
         {text.substr(0, i), std::string(text).erase(i, 1)}) {
      const std::string error = DomainError(damaged);
      if (!error.empty()) {
        EXPECT_THAT(error, StartsWith("d.pddl:"));
      }
    }
  }
}

}  // namespace
}  // namespace cell::ppddl
