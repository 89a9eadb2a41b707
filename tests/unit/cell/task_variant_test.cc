#include "services/cell/running/task_variant.h"

#include <gmock/gmock.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "common/task/task.h"
#include "tests/unit/changed_deployment.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::StrEq;

class TaskVariant : public testing::Test {
 protected:
  void Write(const std::string& name, const std::string& text) const {
    const fs::path folder = task_.get().task_dir / kVariantsFolder;
    fs::create_directories(folder);
    std::ofstream(folder / (name + ".yaml")) << text;
  }
  std::string Complaint(const std::string& name) const {
    try {
      ApplyVariant(task_.get().task_dir, name, task_.get().task_dir);
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  }

  const ChangedDeployment task_{ShippedDeployment()};
};

TEST_F(TaskVariant, MergesMapsAndRemovesAndReplacesKeys) {
  Write("a",
        "domain.yaml:\n"
        "  types: {cone: movable}\n"
        "  goals: {round_pegs: ~, one: [Horizontal(shaft)]}\n");
  const Domain before = LoadTask(task_.get()).domain;
  {
    const VariedTask varied(task_.get(), "a");
    const Domain after = LoadTask(varied.deployment()).domain;
    EXPECT_TRUE(after.vocabulary().types().Find("cone"));
    EXPECT_TRUE(after.vocabulary().types().Find("shaft"));
    EXPECT_EQ(after.FindGoal("round_pegs"), nullptr);
    EXPECT_NE(after.FindGoal("one"), nullptr);
    EXPECT_NE(after.FindGoal("assembled"), nullptr);
  }
  EXPECT_NE(LoadTask(task_.get()).domain.FindGoal("round_pegs"), nullptr)
      << "the task itself stays as it is";
}

TEST_F(TaskVariant, ChangesNothingElseThatAnAliasGaveTheSameValue) {
  std::ofstream(task_.get().task_dir / "numbers.yaml")
      << "a: &shared {x: 1, list: &list [1, 2]}\n"
         "b: *shared\n"
         "c: {list: *list}\n";
  Write("a", "numbers.yaml: {a: {x: 7, list: [3]}}\n");
  ApplyVariant(task_.get().task_dir, "a", task_.get().task_dir);
  const YAML::Node varied =
      YAML::LoadFile((task_.get().task_dir / "numbers.yaml").string());
  const auto list = [](const YAML::Node& node) {
    return node["list"].as<std::vector<int>>();
  };
  EXPECT_EQ(varied["a"]["x"].as<int>(), 7);
  EXPECT_THAT(list(varied["a"]), ElementsAre(3));
  EXPECT_EQ(varied["b"]["x"].as<int>(), 1);
  EXPECT_THAT(list(varied["b"]), ElementsAre(1, 2));
  EXPECT_THAT(list(varied["c"]), ElementsAre(1, 2));
}

TEST_F(TaskVariant, WhatMakesNoSenseIsNamed) {
  fs::remove_all(task_.get().task_dir / kVariantsFolder);
  Write("a", "domain.yaml: {goals: {none: ~}}");
  Write("b", "recipe.yaml: {x: 1}");
  Write("c", "domain.yaml: 3");
  EXPECT_THAT(VariantsOf(task_.get().task_dir), ElementsAre("a", "b", "c"));
  EXPECT_THAT(Complaint("a"), HasSubstr("a.yaml:domain.yaml:goals:none: would "
                                        "be removed, but is not there"));
  EXPECT_THAT(Complaint("b"),
              HasSubstr("b.yaml:recipe.yaml: the task has no such file"));
  EXPECT_THAT(Complaint("c"), HasSubstr("c.yaml:domain.yaml: should be a map"));
  EXPECT_THAT(Complaint("d"), HasSubstr("no variant 'd'; known: a, b, c"));
}

TEST_F(TaskVariant, WhatIsWrongIsNamedInTheTasksOwnFolder) {
  const std::string folder = task_.get().task_dir.string();
  const std::string file = folder + "/variants/a.yaml:";
  const auto complaint = [&](const std::string& text) -> std::string {
    Write("a", text);
    try {
      const VariedTask varied(task_.get(), "a");
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(complaint("\nnone.yaml: {}\n"),
              StrEq(file + "none.yaml: the task has no such file (line 2)"));
  EXPECT_THAT(
      complaint("rules.ndr: {}\n"),
      StrEq(file + "rules.ndr: only YAML files can be varied (line 1)"));
  EXPECT_THAT(complaint("domain.yaml: {}\ndomain.yaml: {}\n"),
              StrEq(file + "domain.yaml: the key already exists (line 2)"));
  EXPECT_THAT(complaint("domain.yaml: {goals: {}, goals: {}}\n"),
              HasSubstr(file + "domain.yaml.goals: the key already exists"));
  EXPECT_THAT(complaint("domain.yaml: {\n"), StartsWith(file));
  EXPECT_THAT(complaint("domain.yaml:\n  goals: {none: ~}\n"),
              HasSubstr(file + "domain.yaml:goals:none: would be removed, but "
                               "is not there (line 2)"));
  try {
    const VariedTask varied(task_.get(), "nope");
    ADD_FAILURE();
  } catch (const std::exception& e) {
    EXPECT_THAT(e.what(), StartsWith(folder + ": the task has no variant"));
  }
}

TEST_F(TaskVariant, ANameThatTheTaskDoesNotKnowIsFoundUnderItsKey) {
  Write("a",
        "demonstrators.yaml:\n"
        "  scripts: {execution: {start: {shift: {lying: true}}}}\n");
  Write("b", "domain.yaml: {types: {cone: movables}}\n");
  const auto complaint = [&](const char* name) -> std::string {
    try {
      const VariedTask varied(task_.get(), name);
      return "";
    } catch (const std::exception& e) {
      return e.what();
    }
  };
  EXPECT_THAT(complaint("a"),
              HasSubstr("variants/a.yaml: demonstrators.yaml:scripts."
                        "execution.start.shift: no part is named 'shift'"));
  EXPECT_THAT(complaint("b"), HasSubstr("variants/b.yaml: domain.yaml:"));
  EXPECT_THAT(complaint("b"), HasSubstr("movables"));
}

TEST_F(TaskVariant, EachThatIsShippedLoads) {
  for (const std::string& name : VariantsOf(ShippedDeployment().task_dir)) {
    const VariedTask varied(ShippedDeployment(), name);
    EXPECT_NO_THROW(LoadTask(varied.deployment())) << name;
  }
}

}  // namespace
}  // namespace cell
