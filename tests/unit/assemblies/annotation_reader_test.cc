#include "common/assemblies/annotation_reader.h"

#include <gmock/gmock.h>

namespace cell::assemblies {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using ProblemKind = AnnotationProblem::Kind;

constexpr char kFile[] = "data/action_both_9033-c13a_9033_user.csv";

AnnotationFile Read(const std::string& text) {
  return ReadAnnotations(text, kFile);
}

TEST(AnnotationReader, ReadsRowsAndTheToyOfTheFileName) {
  const AnnotationFile file = Read(
      "10,20,attach,Turntable  top,base,correct,\r\n"
      "\n"
      "20,30,detach,base,turntable_top,mistake, wrong order \n"
      "30,31,attach,cabin,base,correction");
  EXPECT_THAT(file.problems, IsEmpty());
  EXPECT_EQ(file.sequence.toy, "c13a");
  ASSERT_THAT(file.sequence.actions, SizeIs(3));
  const auto& actions = file.sequence.actions;
  EXPECT_EQ(actions[0].pair, MakePair("base", "turntable top"));
  EXPECT_EQ(actions[0].pair, actions[1].pair);
  EXPECT_EQ(actions[1].verb, Verb::kDetach);
  EXPECT_EQ(actions[1].kind, MistakeKind::kWrongOrder);
  EXPECT_EQ(actions[1].line, 3);
  EXPECT_EQ(actions[2].label, Label::kCorrection);
}

TEST(AnnotationReader, SkipsAHeadingWithoutAWord) {
  const AnnotationFile file =
      Read("start,end,verb,this,that,label,remark\n1,2,attach,a,b,correct,\n");
  EXPECT_THAT(file.problems, IsEmpty());
  EXPECT_THAT(file.sequence.actions, SizeIs(1));
}

TEST(AnnotationReader, ReadsAWrongVerbByWhatIsAttached) {
  const AnnotationFile file = Read(
      "1,2,position,a,b,correct,\n"
      "2,3,interior,b,a,correction,\n");
  ASSERT_THAT(file.sequence.actions, SizeIs(2));
  EXPECT_EQ(file.sequence.actions[0].verb, Verb::kAttach);
  EXPECT_EQ(file.sequence.actions[1].verb, Verb::kDetach);
  ASSERT_THAT(file.problems, SizeIs(2));
  EXPECT_EQ(Show(file.problems[1]),
            std::string(kFile) +
                ":2: 'interior' is no verb; right are attach and detach; read "
                "as detach, since a - b is attached");
}

TEST(AnnotationReader, ReadsAMisspeltVerbAsTheNearest) {
  const AnnotationFile file = Read("1,2,detatch,a,b,correct,\n");
  EXPECT_EQ(file.sequence.actions.at(0).verb, Verb::kDetach);
  ASSERT_THAT(file.problems, SizeIs(1));
  EXPECT_THAT(file.problems[0].text, testing::EndsWith("read as detach"));
}

TEST(AnnotationReader, QuotesLittleOfWhatIsNoText) {
  const AnnotationFile file =
      Read("1,2,attach,a,b," + std::string(5000, 'x') + "\x1b,\n");
  ASSERT_THAT(file.problems, SizeIs(1));
  EXPECT_LT(file.problems[0].text.size(), 200u);
}

TEST(AnnotationReader, NamesEveryOddRowAndKeepsTheRest) {
  const AnnotationFile file = Read(
      "1,2,attach\n"
      "1,2,attach,a,,correct,\n"
      "1,2,attach,a,b\n"
      "5,2,attach,a,c,correct,\n"
      "1,2,attach,a,d,corect,\n"
      "1,2,attach,a,e,splendid,\n"
      "1,2,attach,a,f,mistake,\n"
      "1,2,attach,a,g,mistake,worng order\n"
      "1,2,attach,a,h,mistake,for no reason at all\n"
      "1,2,attach,a,a,correct,\n"
      "1,2,attach,a,i,correct,\n");
  std::vector<ProblemKind> kinds;
  std::vector<int> lines;
  for (const AnnotationProblem& problem : file.problems) {
    kinds.push_back(problem.kind);
    lines.push_back(problem.line);
  }
  EXPECT_THAT(
      kinds,
      ElementsAre(ProblemKind::kMissingColumns, ProblemKind::kMissingName,
                  ProblemKind::kMissingColumns, ProblemKind::kBadFrames,
                  ProblemKind::kUnknownLabel, ProblemKind::kUnknownLabel,
                  ProblemKind::kMissingRemark, ProblemKind::kUnknownRemark,
                  ProblemKind::kUnknownRemark, ProblemKind::kOnePart));
  EXPECT_THAT(lines, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
  EXPECT_EQ(file.num_rows, 11);
  EXPECT_EQ(file.num_skipped, 2);
  const auto& actions = file.sequence.actions;
  ASSERT_THAT(actions, SizeIs(9));
  EXPECT_EQ(actions[0].label, std::nullopt);
  EXPECT_EQ(actions[2].label, Label::kCorrect);
  EXPECT_EQ(actions[3].label, std::nullopt);
  EXPECT_EQ(actions[4].kind, MistakeKind::kNone);
  EXPECT_EQ(actions[5].kind, MistakeKind::kWrongOrder);
  EXPECT_EQ(actions[6].kind, MistakeKind::kNone);
  EXPECT_TRUE(actions[7].pair.is_of_one_name());
}

TEST(AnnotationReader, TakesNoVerbForAPart) {
  const AnnotationFile file = Read(
      "1,2,seat,attach,frame,correct,\n"
      "2,3,seat,frame,detach,correct,\n"
      "3,4,attach,seat,frame,correct,\n");
  EXPECT_THAT(file.sequence.actions, SizeIs(1));
  EXPECT_EQ(file.num_skipped, 2);
  ASSERT_THAT(file.problems, SizeIs(2));
  EXPECT_EQ(file.problems[0].kind, ProblemKind::kVerbAsPart);
  EXPECT_THAT(Show(file.problems[1]),
              testing::HasSubstr(":2: 'detach' is a verb, no part"));
}

TEST(AnnotationReader, NamesARowThatRepeatsAnother) {
  const AnnotationFile file = Read(
      "1,2,attach,seat,frame,correct,\n"
      "2,3,attach,roof,frame,correct,\n"
      "1,2,attach,seat,frame,correct,\n");
  EXPECT_THAT(file.sequence.actions, SizeIs(3));
  ASSERT_THAT(file.problems, SizeIs(1));
  EXPECT_THAT(Show(file.problems[0]),
              testing::HasSubstr(":3: the same as line 1; both are read"));
}

TEST(AnnotationReader, SkipsAByteOrderMark) {
  const AnnotationFile file = Read(
      "\xef\xbb\xbf"
      "1,2,attach,a,b,correct,\n");
  EXPECT_THAT(file.problems, IsEmpty());
}

TEST(AnnotationReader, SaysThatAFileIsEmptyOrNamesNoToy) {
  const AnnotationFile file = ReadAnnotations("\n\n", "notes-x.csv");
  ASSERT_THAT(file.problems, SizeIs(2));
  EXPECT_EQ(file.problems[0].kind, ProblemKind::kNoToy);
  EXPECT_EQ(Show(file.problems[1]), "notes-x.csv:1: holds no action");
}

TEST(AnnotationReader, NormalisesNamesToWhatRulesCanSay) {
  EXPECT_EQ(NormalisedName(" Rear-Body "), "rear_body");
  EXPECT_EQ(NormalisedName("2nd wheel"), "part_2nd_wheel");
  EXPECT_EQ(NormalisedName("?"), "");
}

}  // namespace
}  // namespace cell::assemblies
