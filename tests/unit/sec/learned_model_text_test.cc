#include "common/sec/learned_model_text.h"

#include <gmock/gmock.h>

#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using testing::HasSubstr;

constexpr char kText[] =
    "roles: {X: cylindrical_peg, Y: cylindrical_hole}\n"
    "moved: X\n"
    "pick:\n"
    "  touch: [table]\n"
    "  apart: [Y, any separator]\n"
    "  where: [\"fits(X, Y)\", \"not PegInHole(X, Y)\"]\n"
    "place:\n"
    "  touch: [Y, any separator]\n"
    "  apart: [table]\n"
    "  where: [\"PegInHole(X, Y)\"]\n"
    "chain: {round_hole: 001, table: 100}\n"
    "shown: {assembly 1: 2, assembly 2: 1}";

class LearnedModelText : public testing::Test {
 protected:
  LearnedModel Read(const std::string& text) const {
    const Config config = Config::Parse(text, "m.yaml");
    LearnedModel model = LearnedModelFromConfig(config, words_);
    config.Finish();
    return model;
  }
  std::string ErrorWith(const std::string& from, const std::string& to) const {
    std::string text = kText;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    try {
      Read(text.replace(at, from.size(), to));
    } catch (const ConfigError& e) {
      return e.what();
    }
    return "";
  }

  const ShippedTask task_;
  const SceneWords words_{task_.domain.vocabulary(), task_.parts};
};

TEST_F(LearnedModelText, IsReadAsTheModelItWasWrittenFrom) {
  const LearnedModel model = Read(kText);
  EXPECT_EQ(model.NumShown(), 3);
  EXPECT_EQ(ToText(model, words_.vocabulary), kText);
  EXPECT_EQ(Read(ToText(model, words_.vocabulary)), model);
}

TEST_F(LearnedModelText, KeepsWhatEachDemonstrationHasTaught) {
  const std::string text = std::string(kText) +
                           "\ntaught:\n"
                           "  - by: {assembly 1: 2}\n"
                           "    build: 0.1.0\n"
                           "    types: [round_peg, round_hole]\n"
                           "    pick:\n"
                           "      touch: [table]\n"
                           "      where: [\"not PegInHole(X, Y)\"]\n"
                           "    place:\n"
                           "      where: [\"PegInHole(X, Y)\"]\n"
                           "    chain: {table: 10}\n"
                           "  - by: {assembly 2: 1}\n"
                           "    types: [shaft, shaft_hole]\n"
                           "    pick:\n"
                           "      touch: [table]\n"
                           "    place:\n"
                           "      apart: [table]\n"
                           "    chain: {table: 10}";
  const LearnedModel model = Read(text);
  ASSERT_EQ(model.taught.size(), 2u);
  EXPECT_EQ(model.taught[0].build, "0.1.0");
  EXPECT_EQ(ToText(model, words_.vocabulary), text);
  const auto error_with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const size_t at = changed.rfind(from);
    EXPECT_NE(at, std::string::npos) << from;
    try {
      Read(changed.replace(at, from.size(), to));
    } catch (const ConfigError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(error_with("assembly 2: 1", "assembly 2: 5"),
              HasSubstr("m.yaml:taught: is not of the demonstrations"));
  EXPECT_THAT(error_with("shaft, shaft_hole", "shaft"),
              HasSubstr("taught[1].types: needs one type for each role"));
  EXPECT_THAT(error_with("shaft, shaft_hole", "shaft, well"),
              HasSubstr("there is no type 'well'"));
}

TEST_F(LearnedModelText, IsReadStrictly) {
  EXPECT_EQ(ErrorWith("moved: X", "moved: X"), "");
  EXPECT_THAT(ErrorWith("cylindrical_hole", "well"),
              HasSubstr("m.yaml:roles.Y: there is no type 'well'"));
  EXPECT_THAT(ErrorWith("moved: X", "moved: Z"),
              HasSubstr("m.yaml:moved: 'Z' is not a role"));
  EXPECT_THAT(ErrorWith("touch: [table]", "touch: [chair]"),
              HasSubstr("m.yaml:pick.touch[0]: 'chair' is not a role"));
  EXPECT_THAT(ErrorWith("apart: [table]", "apart: [Y]"),
              HasSubstr("m.yaml:place.apart[0]: is also in touch"));
  EXPECT_THAT(ErrorWith("touch: [Y,", "touch: [X,"),
              HasSubstr("does not touch itself"));
  EXPECT_THAT(ErrorWith("any separator", "any cup"),
              HasSubstr("there is no type 'cup'"));
  EXPECT_THAT(ErrorWith("fits(X, Y)", "fits(Y, X)"),
              HasSubstr("m.yaml:pick.where[0]"));
  EXPECT_THAT(ErrorWith("table: 100", "table: 10"),
              HasSubstr("m.yaml:chain.table: needs one code"));
  EXPECT_THAT(ErrorWith("table: 100", "table: 170"),
              HasSubstr("m.yaml:chain.table: needs one code"));
  EXPECT_THAT(ErrorWith("assembly 1: 2", "assembly 1: 0"),
              HasSubstr("m.yaml:shown.assembly 1"));
  EXPECT_THAT(ErrorWith("moved: X", "moved: X\ncolour: red"),
              HasSubstr("m.yaml:colour"));
}

TEST_F(LearnedModelText, WithoutAChangeOrOfARoleThatIsNotMentionedIsRefused) {
  const std::string head = "roles: {X: separator}\nmoved: X\n";
  const std::string tail = "chain: {table: 10}\nshown: {a: 1}\n";
  EXPECT_THROW(Read(head + "pick: {touch: [table]}\nplace: {}\n" + tail),
               ConfigError);
  EXPECT_NO_THROW(
      Read(head + "pick: {touch: [table]}\nplace: {apart: [table]}\n" + tail));
  EXPECT_THROW(Read("roles: {X: separator, Y: head}\nmoved: X\n"
                    "pick: {touch: [table]}\nplace: {apart: [table]}\n" +
                    tail),
               ConfigError);
}

TEST_F(LearnedModelText, FitsTheArgumentsOfAnActionInTheirOrder) {
  const LearnedModel model = Read(kText);
  const auto& types = words_.vocabulary.types();
  const std::vector<Variable> arguments = {{"H", *types.Find("hole")},
                                           {"P", *types.Find("peg")}};
  const auto fitted = FitToArguments(model, arguments, types);
  ASSERT_TRUE(fitted) << fitted.reason();
  EXPECT_THAT(ToText(*fitted, words_.vocabulary),
              HasSubstr("roles: {H: hole, P: peg}\n"
                        "moved: P\n"));
  EXPECT_THAT(ToText(*fitted, words_.vocabulary), HasSubstr("PegInHole(P, H)"));
  EXPECT_THAT(FitToArguments(model, {arguments.data(), 1}, types).reason(),
              HasSubstr("(cylindrical_peg, cylindrical_hole), but takes "
                        "(hole)"));
}

TEST_F(LearnedModelText, WhatIsFittedTakesAllThatTheActionTakes) {
  const auto& types = words_.vocabulary.types();
  LearnedModel model;
  model.roles = {{"X", *types.Find("shaft")}, {"Y", *types.Find("shaft_hole")}};
  const std::vector<Variable> arguments = {
      {"H", *types.Find("hole")}, {"P", *types.Find("cylindrical_peg")}};
  const auto fitted = FitToArguments(model, arguments, types);
  ASSERT_TRUE(fitted) << fitted.reason();
  EXPECT_EQ(fitted->roles, arguments);
  EXPECT_EQ(fitted->moved, 1u);
}

TEST_F(LearnedModelText, TheNarrowestCommonTypeIsFound) {
  const auto& types = words_.vocabulary.types();
  const auto common = [&](const char* a, const char* b) {
    return types.name(CommonType(types, *types.Find(a), *types.Find(b)));
  };
  EXPECT_EQ(common("round_peg", "round_peg"), "round_peg");
  EXPECT_EQ(common("round_peg", "shaft"), "cylindrical_peg");
  EXPECT_EQ(common("square_peg", "shaft"), "peg");
  EXPECT_EQ(common("head", "shaft"), "movable");
  EXPECT_EQ(common("head", "round_hole"), "object");
}

}  // namespace
}  // namespace cell
