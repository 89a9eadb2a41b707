// How a rule of the task's domain reads, and what it lacks in a state.
#include "common/relational/rule_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/relational/rule_gap.h"
#include "tests/unit/bench_domain.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// The bench, on which a lid is screwed tight by the one tool that fits.
constexpr char kTool[] = R"yaml(
types: {tool: object, lid: object}
constants: {key: tool, tongs: tool, lid: lid, cover: lid}
predicates:
  Fits: {arguments: [tool, lid]}
  Tight: {arguments: [lid]}
  Worn: {arguments: [tool]}
actions:
  Screw:
    arguments: {X: lid}
    rules:
      - references: {T: {type: tool, such_that: ["Fits(T, X)"]}}
        context: ["not Worn(T)", "not Tight(X)"]
        outcomes:
          - probability: 0.75
            effects:
              - Tight(X)
              - {each: {P: tool}, where: ["Fits(P, X)"], then: [Worn(P)]}
          - {probability: 0.2, effects: []}
        noise: 0.05
goals: {tight: [Tight(lid)]}
)yaml";

class ToolBench : public testing::Test {
 protected:
  std::vector<std::string> Lines(const Binding& binding) const {
    const ::cell::Action& screw = bench_.rules->actions()[0];
    return RuleLines(screw, screw.rules[0], binding,
                     bench_.rules->vocabulary());
  }
  RuleGap Gap(const std::set<std::string>& is_true) const {
    const auto gaps = GapsOf(*bench_.rules, screw_lid_, bench_.StateOf(is_true),
                             Agent::kPerson);
    EXPECT_THAT(gaps, SizeIs(1));
    return gaps.at(0);
  }
  std::vector<std::string> Lacks(const std::set<std::string>& is_true) const {
    return ShowGap(*bench_.rules, screw_lid_, Gap(is_true));
  }

  BenchDomain bench_{kTool};
  GroundAction screw_lid_ = bench_.Action("Screw", {"lid"});
};

TEST_F(ToolBench, ARuleReadsWithItsVariables) {
  EXPECT_THAT(Lines({}),
              ElementsAre("Action: Screw(X)", "References: T: Fits(T, X)",
                          "Preconditions: not Worn(T), not Tight(X)",
                          "Effects:", "  0.75: Tight(X)",
                          "    each P: Worn(P) if Fits(P, X)",
                          "  0.20: nothing", "  0.05: noise"));
}

TEST_F(ToolBench, ARuleReadsWithTheObjectsThatItsVariablesStandFor) {
  const Binding binding = {bench_.Object("lid"), bench_.Object("key")};
  EXPECT_THAT(
      Lines(binding),
      ElementsAre("Action: Screw(lid)", "References: T = key: Fits(key, lid)",
                  "Preconditions: not Worn(key), not Tight(lid)", "Effects:",
                  "  0.75: Tight(lid)", "    each P: Worn(P) if Fits(P, lid)",
                  "  0.20: nothing", "  0.05: noise"));
}

TEST_F(ToolBench, ARuleThatCoversLacksNothing) {
  EXPECT_THAT(Lacks({"Fits(key, lid)"}), IsEmpty());
  EXPECT_TRUE(Gap({"Fits(key, lid)"}).is_covered());
  EXPECT_THAT(Gap({"Fits(key, lid)"}).binding,
              ElementsAre(bench_.Object("lid"), bench_.Object("key")));
}

TEST_F(ToolBench, ARuleLacksTheLiteralsThatDoNotHold) {
  EXPECT_THAT(Lacks({"Fits(key, lid)", "Worn(key)", "Tight(lid)"}),
              ElementsAre("not Worn(key)", "not Tight(lid)"));
}

TEST_F(ToolBench, ARuleLacksAnObjectOfWhichThereIsNoneOrMoreThanOne) {
  EXPECT_THAT(Lacks({"Fits(key, lid)", "Fits(tongs, lid)"}),
              ElementsAre("exactly one T with Fits(T, lid)"));
  // Nothing is said of a literal whose object is not known.
  EXPECT_THAT(Lacks({"Tight(lid)", "Worn(key)"}),
              ElementsAre("exactly one T with Fits(T, lid)", "not Tight(lid)"));
}

TEST_F(ToolBench, ARuleThatCoversIsOneThatApplies) {
  // Over all states of the lid and the two tools.
  const std::vector<std::string> names = {"Fits(key, lid)", "Fits(tongs, lid)",
                                          "Worn(key)", "Worn(tongs)",
                                          "Tight(lid)"};
  for (unsigned chosen = 0; chosen < (1u << names.size()); ++chosen) {
    std::set<std::string> is_true;
    for (size_t i = 0; i < names.size(); ++i) {
      if ((chosen >> i & 1u) != 0) is_true.insert(names[i]);
    }
    const auto applicable = ApplicableRules(
        bench_.rules->ActionOf(screw_lid_), screw_lid_.arguments,
        bench_.StateOf(is_true), bench_.rules->vocabulary(), Agent::kPerson);
    EXPECT_EQ(Gap(is_true).is_covered(), !applicable.empty()) << chosen;
  }
}

}  // namespace
}  // namespace cell
