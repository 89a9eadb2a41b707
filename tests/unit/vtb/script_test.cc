#include "services/vtb/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace cell {

using namespace vtb;
namespace {

constexpr char kTask[] = CELL_SOURCE_DIR "/deploy/tasks/cranfield/";

std::string ShippedText() {
  std::ifstream file(std::string(kTask) + "demonstrators.yaml");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string ErrorOf(const std::string& what, const std::string& by) {
  std::string text = ShippedText();
  const size_t at = text.find(what);
  if (at == std::string::npos) return "not found: " + what;
  text.replace(at, what.size(), by);
  const PartTable table =
      PartTable::FromConfig(Config::Load(std::string(kTask) + "parts.yaml"));
  try {
    Demonstrations::FromConfig(Config::Parse(text, "demonstrations.yaml"),
                               table);
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(Demonstrations, ReadHowOftenAPersonTriesSomethingOut) {
  const PartTable table =
      PartTable::FromConfig(Config::Load(std::string(kTask) + "parts.yaml"));
  const auto demonstrations = Demonstrations::FromConfig(
      Config::Parse(ShippedText(), "demonstrators.yaml"), table);
  EXPECT_EQ(demonstrations.scripts.at("attempts").attempts.low, 4);
  EXPECT_EQ(demonstrations.scripts.at("attempts").attempts.high, 6);
  EXPECT_EQ(demonstrations.scripts.at("assembly").attempts.high, 0);
  EXPECT_THAT(ErrorOf("attempts: {count: [4, 6]}", "attempts: {count: [6, 4]}"),
              testing::HasSubstr("should be [low, high]"));
}

TEST(Demonstrations, LoadsTheShippedTask) {
  EXPECT_EQ(ErrorOf("goal: ", "goal: "), "");
}

TEST(Demonstrations, RefusesWhatItDoesNotKnowByFileAndKey) {
  using testing::StartsWith;
  EXPECT_THAT(ErrorOf("bend: ", "bent: "),
              StartsWith("demonstrations.yaml:human_motion.bend: missing"));
  EXPECT_THAT(ErrorOf("after: [shaft]", "after: [shift]"),
              StartsWith("demonstrations.yaml:placements.pendulum.after"));
  EXPECT_THAT(ErrorOf("after: [shaft]", "after: [head]"),
              testing::HasSubstr("waits for itself"));
  EXPECT_THAT(ErrorOf("site: shaft_hole", "site: shaft_whole"),
              StartsWith("demonstrations.yaml:placements.shaft.site"));
  EXPECT_THAT(ErrorOf("place: [round_pegs]", "place: [head]"),
              StartsWith("demonstrations.yaml:scripts.two_pegs.place"));
  EXPECT_THAT(ErrorOf("[assembly, execution]", "[assembly, excution]"),
              testing::AllOf(StartsWith("demonstrations.yaml:default[1]"),
                             testing::HasSubstr("did you mean 'execution'?")));
}

}  // namespace
}  // namespace cell
