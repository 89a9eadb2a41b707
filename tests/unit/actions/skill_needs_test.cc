#include "common/actions/skill_needs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/relational/domain.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr char kWords[] = R"yaml(
types: {part: object, hole: object, arm: object}
constants: {bolt: part, hole: hole, left: arm, right: arm}
predicates:
  In: {arguments: [part, hole]}
)yaml";
constexpr char kReports[] = R"yaml(
  Has: {arguments: [part, arm], reported: held}
  Gets: {arguments: [arm, part], reported: reachable}
)yaml";
constexpr char kActions[] = R"yaml(
actions:
  Insert:
    arguments: {X: part, Y: hole}
    skill: {name: insert, part: X, site: Y, arm: right}
    rules:
      - context: ["not In(X, _)"]
        outcomes: [{probability: 0.75, effects: ["In(X, Y)"]}]
        noise: 0.25
  Pull:
    arguments: {X: part, Y: hole}
    skill: {name: pull, part: X, arm: right}
    rules:
      - context: ["In(X, Y)"]
        outcomes: [{probability: 1, effects: ["not In(X, Y)"]}]
        noise: 0
goals: {done: ["In(bolt, hole)"]}
)yaml";

Domain DomainFrom(const std::string& text) {
  return Domain::FromConfig(Config::Parse(text, "d.yaml"), PartTable());
}

std::vector<std::string> TextsOf(const std::vector<Literal>& literals,
                                 const Domain& domain, const Action& action) {
  std::vector<std::string> texts;
  for (const Literal& literal : literals) {
    texts.push_back(ToText(literal, domain.vocabulary(), action.arguments));
  }
  return texts;
}

TEST(SkillNeeds, AnArmInsertsWhatItHoldsOrWhatItCanTakeWithAnEmptyHand) {
  const Domain domain = DomainFrom(std::string(kWords) + kReports + kActions);
  const Action insert =
      WithSkillNeeds(domain.actions()[0], domain.vocabulary());
  ASSERT_EQ(insert.rules.size(), 3U);
  const auto context_of = [&](size_t rule) {
    return TextsOf(insert.rules[rule].context, domain, insert);
  };
  const auto effects_of = [&](size_t rule) {
    return TextsOf(insert.rules[rule].outcomes.at(0).effects.at(0).then, domain,
                   insert);
  };
  EXPECT_THAT(insert.rules[0].agents, ElementsAre(Agent::kPerson));
  EXPECT_THAT(context_of(0), ElementsAre("not In(X, _)"));
  EXPECT_THAT(insert.rules[1].agents, ElementsAre(Agent::kRobot));
  EXPECT_THAT(context_of(1), ElementsAre("not In(X, _)", "Has(X, right)"));
  EXPECT_THAT(effects_of(1), ElementsAre("In(X, Y)", "not Has(X, right)"));
  EXPECT_THAT(context_of(2), ElementsAre("not In(X, _)", "Gets(right, X)",
                                         "not Has(_, right)"));
  EXPECT_THAT(effects_of(2), ElementsAre("In(X, Y)"));
}

TEST(SkillNeeds, DoneTwiceChangeNothingMore) {
  const Domain domain = DomainFrom(std::string(kWords) + kReports + kActions);
  const Action once = WithSkillNeeds(domain.actions()[0], domain.vocabulary());
  EXPECT_EQ(WithSkillNeeds(once, domain.vocabulary()), once);
}

TEST(SkillNeeds, OtherSkillsAndArmsThatReportNothingHaveNone) {
  const Domain domain = DomainFrom(std::string(kWords) + kReports + kActions);
  const Action& pull = domain.actions()[1];
  EXPECT_EQ(WithSkillNeeds(pull, domain.vocabulary()), pull);
  const Domain silent = DomainFrom(std::string(kWords) + kActions);
  EXPECT_THAT(NeedsOf(*silent.actions()[0].skill, silent.vocabulary()),
              IsEmpty());
}

}  // namespace
}  // namespace cell
