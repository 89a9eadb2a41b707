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

/// Of a script whose parts start so.
std::string ErrorOfStart(const std::string& start) {
  const std::string script = "two_pegs: {hands: 1, place: [round_pegs]";
  return ErrorOf(script + "}", script + ", start: {" + start + "}}");
}

TEST(Demonstrations, ReadWhereAPartIsAtTheStart) {
  EXPECT_EQ(ErrorOfStart("shaft: {lying: true}"), "");
  EXPECT_EQ(ErrorOfStart("separator: {site: base.separator}"), "");
}

TEST(Demonstrations, RefuseAStartThatCannotBe) {
  using testing::HasSubstr;
  EXPECT_THAT(
      ErrorOfStart("shift: {lying: true}"),
      testing::AllOf(
          testing::StartsWith(
              "demonstrations.yaml:scripts.two_pegs.start.shift: no part"),
          HasSubstr("did you mean 'shaft'?")));
  EXPECT_THAT(ErrorOfStart("base: {lying: true}"),
              HasSubstr("'base' cannot be moved"));
  EXPECT_THAT(ErrorOfStart("shaft: {}"),
              HasSubstr("should be either {lying: true} or {site: NAME}"));
  EXPECT_THAT(ErrorOfStart("shaft: {lying: true, site: base.shaft}"),
              HasSubstr("should be either {lying: true} or {site: NAME}"));
  EXPECT_THAT(ErrorOfStart("shaft: {standing: true, lying: true}"),
              HasSubstr("standing"));
  EXPECT_THAT(ErrorOfStart("shaft: {site: base.shift}"),
              HasSubstr("start.shaft.site: no part has a site 'base.shift'"));
  EXPECT_THAT(ErrorOfStart("shaft: {site: base.round_1}"),
              HasSubstr("'shaft' does not fit 'base.round_1'"));
  EXPECT_THAT(ErrorOfStart("head: {site: pendulum.head}"),
              HasSubstr("'pendulum' lies anywhere at the start"));
  EXPECT_THAT(ErrorOfStart("round_peg_1: {site: base.round_1}, "
                           "round_peg_2: {site: base.round_1}"),
              HasSubstr("another part starts at 'base.round_1'"));
}

}  // namespace
}  // namespace cell
