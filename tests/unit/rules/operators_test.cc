// What each search operator proposes.
#include "common/rules/learning/operators/operators.h"

#include <gmock/gmock.h>

#include "common/rules/learning/learner.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr char kDoorSymbols[] = R"(
gate 0 constant
push 1 action
open 1 primitive
locked 1 primitive
near 2 primitive
width 1 primitive integers
)";

// Doors open when they are pushed, unless they are locked. With a, what is near
// it opens, too.
constexpr char kDoorData[] = R"(
locked(a) near(a b) width(a)=1 width(b)=3
push(a)
locked(a) near(a b) width(a)=1 width(b)=3
near(a b) near(c c) width(a)=2 width(b)=2
push(b)
near(a b) near(c c) open(b) width(a)=2 width(b)=2
near(gate b) width(gate)=2 width(b)=3
push(gate)
near(gate b) open(gate) width(gate)=2 width(b)=3
near(a b) width(a)=3 width(b)=3
push(a)
open(a) open(b) near(a b) width(a)=3 width(b)=3
)";

class SearchOperatorTest : public testing::Test {
 protected:
  SearchOperatorTest() {
    for (const Experience& e : set_.experiences) search_.Add(e);
  }

  int Number(const char* symbol, Comparison comparison, int32_t term,
             int value = 0) {
    Feature feature;
    feature.symbol = *set_.world->symbols().Find(symbol);
    feature.comparison = comparison;
    feature.value = value;
    feature.terms[0] = term;
    return search_.table().Number(feature);
  }

  /// near(X, self)
  int NearReference() {
    Feature feature;
    feature.symbol = *set_.world->symbols().Find("near");
    feature.terms = {0, Feature::kSelf, Feature::kNone};
    return search_.table().Reference({feature});
  }

  void Put(std::vector<int> references, std::vector<int> context) {
    search_.Apply(
        {{}, {*search_.Make(std::move(references), std::move(context))}});
  }

  /// What is proposed, each with its new rules.
  std::vector<std::string> ProposalsOf(void (*op)(RuleSearch&,
                                                  const Propose&)) {
    std::vector<std::string> texts;
    op(search_, [&](const Proposal& proposal) {
      std::string text = "-" + std::to_string(proposal.removed.size());
      for (const SearchRule& rule : proposal.added) {
        text +=
            "\n" + ToText(ToRule(rule, search_.table()), set_.world->symbols());
      }
      texts.push_back(text);
    });
    return texts;
  }

  ExperienceSet set_ = ExperiencesFrom(kDoorSymbols, kDoorData);
  RuleSearch search_{set_.world, *set_.world->symbols().Find("push"), {}};
};

TEST_F(SearchOperatorTest, ExplainExamplesMakesARuleWhereThereIsNone) {
  const auto proposals = ProposalsOf(ExplainExamples);
  EXPECT_THAT(proposals, Contains(HasSubstr("open(X)")));
  EXPECT_THAT(proposals, testing::Each(HasSubstr("-0\nAction: push(X)")));
}

TEST_F(SearchOperatorTest, ExplainExamplesAddsReferencesForOtherObjects) {
  // All but the fourth experience are explained.
  Put({}, {Number("locked", Comparison::kFalse, 0)});
  std::string best;
  double best_score = search_.score();
  ExplainExamples(search_, [&](const Proposal& proposal) {
    if (search_.ScoreWith(proposal) <= best_score) return;
    best_score = search_.ScoreWith(proposal);
    best = ToText(ToRule(proposal.added[0], search_.table()),
                  set_.world->symbols());
  });
  EXPECT_THAT(best, HasSubstr("References: Y: "));
  EXPECT_THAT(best, HasSubstr("open(X), open(Y)"));
}

TEST_F(SearchOperatorTest, DropRulesProposesToDropEachRule) {
  Put({}, {Number("locked", Comparison::kTrue, 0)});
  Put({}, {Number("locked", Comparison::kFalse, 0)});
  EXPECT_THAT(ProposalsOf(DropRules), testing::ElementsAre("-1", "-1"));
}

TEST_F(SearchOperatorTest, DropLitsDropsOneLiteralOfTheContext) {
  Put({}, {Number("locked", Comparison::kFalse, 0),
           Number("width", Comparison::kEqual, 0, 3)});
  const auto proposals = ProposalsOf(DropLits);
  ASSERT_EQ(proposals.size(), 2u);
  EXPECT_THAT(proposals, Contains(HasSubstr("Preconditions: width(X) = 3\n")));
  EXPECT_THAT(proposals, Contains(HasSubstr("Preconditions: not locked(X)\n")));
}

TEST_F(SearchOperatorTest, DropLitsKeepsOneLiteralOfAReference) {
  Put({NearReference()}, {});
  EXPECT_THAT(ProposalsOf(DropLits), testing::IsEmpty());
}

TEST_F(SearchOperatorTest, DropRefsDropsAllThatNamesTheReference) {
  const int reference = NearReference();
  Put({reference}, {Number("locked", Comparison::kFalse, reference),
                    Number("open", Comparison::kFalse, 0)});
  const auto proposals = ProposalsOf(DropRefs);
  ASSERT_EQ(proposals.size(), 1u);
  EXPECT_THAT(proposals[0], HasSubstr("Preconditions: not open(X)\n"));
  EXPECT_THAT(proposals[0], testing::Not(HasSubstr("References")));
}

TEST_F(SearchOperatorTest, GeneralizeEqualityProposesBothSides) {
  Put({}, {Number("width", Comparison::kEqual, 0, 2)});
  const auto proposals = ProposalsOf(GeneralizeEquality);
  ASSERT_EQ(proposals.size(), 2u);
  EXPECT_THAT(proposals[0], HasSubstr("Preconditions: width(X) <= 2\n"));
  EXPECT_THAT(proposals[1], HasSubstr("Preconditions: width(X) >= 2\n"));
}

TEST_F(SearchOperatorTest, ChangeRangesTriesAllValuesThatWereSeen) {
  Put({}, {Number("width", Comparison::kAtLeast, 0, 2)});
  const auto proposals = ProposalsOf(ChangeRanges);
  ASSERT_EQ(proposals.size(), 3u);
  for (const char* value : {"1", "2", "3"}) {
    EXPECT_THAT(proposals, Contains(HasSubstr(std::string("width(X) >= ") +
                                              value + "\n")));
  }
}

TEST_F(SearchOperatorTest, SplitOnLitsMakesTwoRulesThatShareNothing) {
  Put({}, {});
  const auto proposals = ProposalsOf(SplitOnLits);
  EXPECT_THAT(proposals,
              Contains(testing::AllOf(HasSubstr("Preconditions: locked(X)\n"),
                                      HasSubstr("not locked(X)\n"))));
  SplitOnLits(search_, [&](const Proposal& proposal) {
    ASSERT_EQ(proposal.added.size(), 2u);
    EXPECT_FALSE(proposal.added[0].covers.Meets(proposal.added[1].covers));
  });
}

TEST_F(SearchOperatorTest, AddLitsAddsLiteralsThatCoverLess) {
  Put({}, {});
  const int num_covered = search_.rules()[0].covers.Count();
  int num_proposals = 0;
  AddLits(search_, [&](const Proposal& proposal) {
    ++num_proposals;
    EXPECT_EQ(proposal.added[0].context.size(), 1u);
    EXPECT_LT(proposal.added[0].covers.Count(), num_covered);
  });
  EXPECT_GT(num_proposals, 2);
}

TEST_F(SearchOperatorTest, AddRefsAddsAReference) {
  Put({}, {});
  EXPECT_THAT(ProposalsOf(AddRefs),
              Contains(HasSubstr("References: Y: near(X, Y)\n")));
}

TEST_F(SearchOperatorTest, SplitVariablesMakesARuleForEachConstant) {
  Put({}, {});
  const auto proposals = ProposalsOf(SplitVariables);
  ASSERT_EQ(proposals.size(), 1u);
  EXPECT_THAT(proposals[0], HasSubstr("Preconditions: X = gate\n"));
  EXPECT_THAT(proposals[0], HasSubstr("Preconditions: X != gate\n"));
}

TEST_F(SearchOperatorTest, RaiseConstantsTakesTheConstantAway) {
  Feature is_gate;
  is_gate.symbol = Literal::kSame;
  is_gate.terms = {0, Feature::ObjectCode(0), Feature::kNone};
  Put({}, {search_.table().Number(is_gate)});
  const auto proposals = ProposalsOf(RaiseConstants);
  ASSERT_EQ(proposals.size(), 1u);
  EXPECT_THAT(proposals[0], HasSubstr("Preconditions: none\n"));
}

TEST_F(SearchOperatorTest, RaiseConstantsPutsAVariableInItsPlace) {
  Put({}, {Number("locked", Comparison::kFalse, Feature::ObjectCode(0))});
  EXPECT_THAT(ProposalsOf(RaiseConstants),
              Contains(HasSubstr("Preconditions: not locked(X)\n")));
}

TEST_F(SearchOperatorTest, NoAppliedStepLowersTheScore) {
  double last = search_.score();
  bool is_better = true;
  while (is_better) {
    is_better = false;
    for (const SearchOperator& op : kSearchOperators) {
      std::optional<Proposal> best;
      double best_score = last + 1e-7;
      op.propose(search_, [&](const Proposal& proposal) {
        if (search_.ScoreWith(proposal) <= best_score) return;
        best_score = search_.ScoreWith(proposal);
        best = proposal;
      });
      if (!best) continue;
      search_.Apply(*best);
      // What was promised, and never less than before.
      EXPECT_NEAR(search_.score(), best_score, 1e-9) << op.name;
      EXPECT_GT(search_.score(), last) << op.name;
      last = search_.score();
      is_better = true;
    }
  }
  EXPECT_TRUE(search_.Unexplained().IsEmpty());
}

}  // namespace
}  // namespace cell::rules
