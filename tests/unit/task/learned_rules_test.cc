#include "common/task/learned_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "common/task/task.h"
#include "tests/unit/changed_deployment.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

constexpr char kFile[] = "rules.ndr";

class LearnedRulesOfTask : public testing::Test {
 protected:
  void Learn(const std::string& rules) const {
    std::ofstream(task_.get().task_dir / kFile) << rules;
  }
  const Action& ActionOf(const Task& task, const std::string& name) const {
    return task.domain
        .actions()[static_cast<size_t>(task.domain.FindAction(name).value())];
  }
  std::string Complaint() const {
    try {
      LoadTask(task_.get());
    } catch (const ConfigError& e) {
      return e.what();
    }
    return "no error";
  }

  const ChangedDeployment task_{ShippedDeployment()};
  const std::string path_ = (task_.get().task_dir / kFile).string();
  const std::string separator_ =
      "Action: PlaceSeparator(X)\n"
      "Preconditions: Clear(X)\n"
      "Effects:\n"
      "  0.75: SeparatorPlaced(X)\n"
      "  0.25: noise\n";
};

TEST_F(LearnedRulesOfTask, BecomeThoseOfItsActions) {
  Learn(separator_);
  const Task task = LoadTask(task_.get());
  const Action& separator = ActionOf(task, "PlaceSeparator");
  // For the person, and for the robot with and without the part in its hand.
  ASSERT_THAT(separator.rules, SizeIs(3));
  EXPECT_FALSE(separator.rules[0].IsFor(Agent::kRobot));
  EXPECT_EQ(separator.rules[0].context.size(), 1U);
  EXPECT_EQ(separator.rules[0].outcomes.at(0).probability, 0.75);
  EXPECT_THAT(ActionOf(task, "PlaceSquarePeg").rules, SizeIs(0));
  EXPECT_THAT(ActionOf(task, "PutDown").rules, SizeIs(1));
}

TEST_F(LearnedRulesOfTask, AreLeftOutOnRequest) {
  const Task task = LoadTask(task_.get(), LearnedRules::kLeaveOut);
  EXPECT_THAT(ActionOf(task, "PlaceSeparator").rules, SizeIs(0));
  EXPECT_FALSE(ActionOf(LoadTask(task_.get()), "PlaceSeparator").rules.empty());
}

TEST_F(LearnedRulesOfTask, OutliveAChangeOfTheTypes) {
  const auto rules = ActionOf(LoadTask(task_.get()), "PlaceSeparator").rules;
  task_.Change("domain.yaml", "types:\n", "types:\n  cone: movable\n");
  const Task task = LoadTask(task_.get());
  EXPECT_EQ(ActionOf(task, "PlaceSeparator").rules.size(), rules.size());
}

TEST_F(LearnedRulesOfTask, TellWhatUndoesWhatAsEventChainsDo) {
  for (const auto learned : {LearnedRules::kRead, LearnedRules::kLeaveOut}) {
    const Task task = LoadTask(task_.get(), learned);
    for (const auto& [undoing, undone] :
         {std::pair{"RemoveRoundPeg", "PlaceRoundPeg"},
          {"RemoveSquarePeg", "PlaceSquarePeg"},
          {"RemoveSeparator", "PlaceSeparator"},
          {"RemovePendulum", "PlacePendulum"},
          {"RemoveHead", "ScrewHead"},
          {"RemoveFacePlate", "PlaceFacePlate"}}) {
      EXPECT_EQ(ActionOf(task, undoing).undoes, task.domain.FindAction(undone))
          << undoing;
      EXPECT_EQ(ActionOf(task, undone).undoes, std::nullopt) << undone;
    }
    EXPECT_EQ(ActionOf(task, "Raise").undoes, std::nullopt);
    EXPECT_EQ(ActionOf(task, "Present").undoes, std::nullopt);
  }
}

TEST_F(LearnedRulesOfTask, WithoutThemAndWithoutChainsNothingIsUndone) {
  std::ofstream(task_.get().task_dir / kSecModelsFile) << "models: {}\n";
  const Task task = LoadTask(task_.get(), LearnedRules::kLeaveOut);
  EXPECT_EQ(ActionOf(task, "RemoveHead").undoes, std::nullopt);
  EXPECT_EQ(ActionOf(LoadTask(task_.get()), "RemoveHead").undoes,
            task.domain.FindAction("ScrewHead"));
}

TEST_F(LearnedRulesOfTask, ErrorsNameTheLine) {
  Learn("\n" + separator_ + separator_ + "Action: Fly(X)\n");
  EXPECT_THAT(Complaint(), StartsWith(path_ + ":12: there is no action 'Fly'"));
  Learn(separator_ + "\nAction: RemoveSeparator(X)\nPreconditions: none\n" +
        "Effects:\n  1: Clear(Y)\n  0: noise\n");
  EXPECT_THAT(Complaint(), StartsWith(path_ + ":10: there is no variable 'Y'"));
  Learn(separator_ + "\nAction: RemoveSeparator(X)\nPreconditions: none\n" +
        "Effects:\n  1: Horizontal(X)\n  0: noise\n");
  EXPECT_THAT(Complaint(),
              StartsWith(path_ + ":7: a rule of RemoveSeparator: "
                                 "'Horizontal(X)' changes what is not"));
}

TEST_F(LearnedRulesOfTask, RefuseAnActionThatHasRulesByHand) {
  Learn(
      "Action: PutDown(X, Y)\nPreconditions: Clear(X)\nEffects:\n"
      "  1: not Clear(X)\n  0: noise\n");
  EXPECT_THAT(Complaint(),
              StartsWith(path_ + ":1: 'PutDown' has rules in domain.yaml"));
}

TEST_F(LearnedRulesOfTask, AFileWithoutARuleIsAnError) {
  for (const char* text : {"", "\n# nothing\n", "Clear 1 primitive binary\n"}) {
    Learn(text);
    EXPECT_THAT(Complaint(), StartsWith(path_ + ": holds no rule"));
  }
}

TEST_F(LearnedRulesOfTask, WhatStandsBeforeTheRulesHasToBeSymbols) {
  Learn("Clear 1 primitive binary\n\x01\xff\x80 noise\n");
  EXPECT_THAT(Complaint(), StartsWith(path_ + ":2: expected the name of a"));
  Learn("Acton: PlaceSeparator(X)\n" + separator_);
  EXPECT_THAT(Complaint(), StartsWith(path_ + ":1: expected"));
}

TEST_F(LearnedRulesOfTask, AFolderIsNoFile) {
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  EXPECT_THAT(Complaint(), HasSubstr("domain.yaml:learned_rules: there is no "
                                     "file 'rules.ndr'"));
}

TEST_F(LearnedRulesOfTask, AFileThatIsNotThereIsNamed) {
  std::filesystem::remove(task_.get().task_dir / kFile);
  EXPECT_THAT(Complaint(), HasSubstr("domain.yaml:learned_rules: there is no "
                                     "file 'rules.ndr'"));
}

}  // namespace
}  // namespace cell
