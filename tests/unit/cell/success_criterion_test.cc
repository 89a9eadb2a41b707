#include "services/cell/scoring/success_criterion.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string ShippedText() {
  std::stringstream text;
  text << std::ifstream(ShippedDeployment().task_dir / "success.yaml").rdbuf();
  return text.str();
}

std::string With(const std::string& what, const std::string& by) {
  std::string text = ShippedText();
  const size_t at = text.find(what);
  if (at == std::string::npos) return "not found: " + what;
  return text.replace(at, what.size(), by);
}

SuccessCriterion Load(const std::string& text) {
  const ShippedTask task;
  return SuccessCriterion::FromConfig(Config::Parse(text, "success.yaml"),
                                      task.domain, task.parts);
}

std::string ErrorOf(const std::string& what, const std::string& by) {
  try {
    Load(With(what, by));
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(SuccessCriterion, HasTolerancesOfItsOwn) {
  const SuccessCriterion success = Load(ShippedText());
  EXPECT_EQ(success.literals.size(), 9u);
  const int screwed = *success.vocabulary.FindPredicate("HeadScrewed");
  EXPECT_NEAR(success.seats.at(screwed).tolerance.z, 0.0002, 1e-12);
  EXPECT_EQ(success.seats.at(screwed).site, "pendulum.head");
}

TEST(SuccessCriterion, NamesALiteralByItsSite) {
  const SuccessCriterion success = Load(ShippedText());
  std::vector<std::string> names;
  for (const Literal& literal : success.literals) {
    names.push_back(success.NameOf(literal));
  }
  EXPECT_THAT(names,
              testing::IsSupersetOf({"base.round_1", "base.shaft",
                                     "base.separator", "pendulum.head"}));
}

TEST(SuccessCriterion, IsTheGoalThatItNames) {
  EXPECT_EQ(Load(With("goal: assembled", "goal: round_pegs")).literals.size(),
            2u);
}

TEST(SuccessCriterion, RefusesWhatItDoesNotKnowByFileAndKey) {
  ASSERT_EQ(ErrorOf("goal: ", "goal: "), "");
  EXPECT_THAT(ErrorOf("goal: assembled", "goal: asembled"),
              StartsWith("success.yaml:goal: domain.yaml has no goal "
                         "'asembled'; it has: assembled, round_pegs"));
  EXPECT_THAT(ErrorOf("  HeadScrewed:", "  HeadScrewd:"),
              StartsWith("success.yaml:seated.HeadScrewd: domain.yaml has no "
                         "predicate"));
  EXPECT_THAT(
      ErrorOf("  PegInHole: {z_mm: 0.8, xy_mm: 3, tilt_deg: 1, yaw_deg: 10}\n",
              ""),
      StartsWith("success.yaml:seated: does not mention PegInHole(_, "
                 "base.round_1), which 'assembled' wants"));
  EXPECT_THAT(ErrorOf("site: pendulum.head", "site: pendulum.had"),
              StartsWith("success.yaml:seated.HeadScrewed.site: no part has"));
  EXPECT_THAT(ErrorOf("site: pendulum.head, ", ""),
              StartsWith("success.yaml:seated.HeadScrewed: HeadScrewed has 1 "
                         "arguments"));
  EXPECT_THAT(ErrorOf("z_mm: 0.2", "z_m: 0.2"),
              StartsWith("success.yaml:seated.HeadScrewed.z_mm: missing"));
  EXPECT_THAT(ErrorOf("HeadScrewed: {", "HeadScrewed: {slack: 2, "),
              StartsWith("success.yaml:seated.HeadScrewed.slack"));
}

}  // namespace
}  // namespace cell
