#include "services/cell/evaluations/mistakes_evaluation.h"

#include <gmock/gmock.h>

#include "services/cell/evaluations/pair_orders.h"
#include "tests/unit/assemblies/small_assemblies.h"

namespace cell::cli {
namespace {

using assemblies::AssemblySequence;
using assemblies::Label;
using assemblies::MakeSequence;

/// Toys whose seat comes before the roof; each has a person who errs and one
/// who does not.
std::vector<AssemblySequence> SmallToys(int number) {
  std::vector<AssemblySequence> sequences;
  for (int i = 0; i < number; ++i) {
    const std::string toy = "t" + std::to_string(i);
    sequences.push_back(MakeSequence(
        {"attach,roof,frame,mistake,wrong order",
         "detach,roof,frame,correction,", "attach,seat,frame,correct,",
         "attach,roof,frame,correct,"},
        toy));
    sequences.push_back(MakeSequence(
        {"attach,seat,frame,correct,", "attach,roof,frame,correct,",
         "detach,roof,frame,mistake,", "attach,roof,frame,correct,"},
        toy));
  }
  return sequences;
}

TEST(MistakesEvaluation, JudgesOneSequenceOfEachToyByTheRest) {
  auto sequences = SmallToys(6);
  sequences.push_back(MakeSequence({"attach,a,b,correct,"}, "alone"));
  const MistakesResult result =
      EvaluateMistakes(GroupByToy(sequences), {}, [](const auto&) {});
  ASSERT_EQ(result.toys.size(), 6u);
  EXPECT_EQ(result.chosen.size(), 5u);
  LabelCounts sum;
  for (const auto& [toy, row] : result.toys) {
    EXPECT_EQ(row.num_sequences, 2);
    EXPECT_EQ(row.num_actions, 16);
    sum.Add(row.counts);
  }
  // What the other toys teach is enough where this one's erring person is
  // the one to be judged.
  EXPECT_DOUBLE_EQ(sum.MacroF1(), 1);
}

TEST(MistakesEvaluation, IsTheSameForTheSameSeed) {
  const auto sequences = SmallToys(4);
  std::string shown[2];
  std::map<std::string, ToyResult> toys[2];
  for (int i = 0; i < 2; ++i) {
    toys[i] =
        EvaluateMistakes(GroupByToy(sequences), {}, [&](const auto& text) {
          shown[i] += text;
        }).toys;
  }
  EXPECT_FALSE(shown[0].empty());
  EXPECT_EQ(shown[0], shown[1]);
  for (const auto& [toy, row] : toys[0]) {
    EXPECT_EQ(row.counts.At(Label::kMistake, Label::kMistake),
              toys[1].at(toy).counts.At(Label::kMistake, Label::kMistake));
  }
}

TEST(MistakesEvaluation, PairOrdersFlagOnlyWhatCameTheOtherWayEverywhere) {
  const AssemblySequence shown = MakeSequence(
      {"attach,seat,frame,correct,", "attach,roof,frame,correct,"});
  const AssemblySequence reversed =
      MakeSequence({"attach,roof,frame,mistake,", "attach,seat,frame,correct,",
                    "detach,seat,frame,correct,"});
  EXPECT_THAT(JudgeByPairOrders({&shown}, reversed),
              testing::ElementsAre(Label::kCorrect, Label::kMistake,
                                   Label::kCorrection));
  EXPECT_THAT(JudgeByPairOrders({&shown, &reversed}, shown),
              testing::ElementsAre(Label::kCorrect, Label::kCorrect));
}

TEST(LabelCountsFigures, AreThoseOfTheirDefinitions) {
  LabelCounts counts;
  counts.Add(Label::kCorrect, Label::kCorrect, 6);
  counts.Add(Label::kCorrect, Label::kMistake, 2);
  counts.Add(Label::kMistake, Label::kMistake, 1);
  counts.Add(Label::kMistake, Label::kCorrect, 1);
  EXPECT_DOUBLE_EQ(counts.Accuracy(), 0.7);
  EXPECT_DOUBLE_EQ(counts.Precision(Label::kMistake), 1.0 / 3);
  EXPECT_DOUBLE_EQ(counts.Recall(Label::kMistake), 0.5);
  EXPECT_DOUBLE_EQ(counts.F1(Label::kMistake), 0.4);
  EXPECT_DOUBLE_EQ(counts.F1(Label::kCorrection), 0);
  EXPECT_DOUBLE_EQ(counts.MacroF1(), (0.8 + 0.4) / 3);
}

TEST(LabelCountsFigures, TheBootstrapHoldsTheFigureAndNarrowsWithMoreGroups) {
  std::vector<LabelCounts> few(6);
  for (size_t i = 0; i < few.size(); ++i) {
    few[i].Add(Label::kCorrect, i % 2 == 0 ? Label::kCorrect : Label::kMistake);
  }
  std::vector<LabelCounts> many;
  for (int i = 0; i < 20; ++i) many.insert(many.end(), few.begin(), few.end());
  const Interval wide = BootstrapInterval(few, &LabelCounts::Accuracy, 1);
  const Interval narrow = BootstrapInterval(many, &LabelCounts::Accuracy, 1);
  EXPECT_LT(wide.low, narrow.low);
  EXPECT_LT(narrow.low, 0.5);
  EXPECT_GT(narrow.high, 0.5);
  EXPECT_GT(wide.high, narrow.high);
}

}  // namespace
}  // namespace cell::cli
