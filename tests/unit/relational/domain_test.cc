#include "common/relational/domain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace cell {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr char kTypes[] = R"yaml(
types: {thing: object, box: thing, crate: box, place: object}
constants: {b1: box, b2: crate, p1: place, p2: place}
static_facts:
  near: {arguments: [place, place], facts: [[p1, p2]]}
)yaml";
constexpr char kPredicates[] = R"yaml(
predicates:
  Open: {arguments: [box]}
  At: {arguments: [thing, place], geometry: {deep: 1}}
  Calm: {arguments: []}
)yaml";
constexpr char kActions[] = R"yaml(
actions:
  Move:
    arguments: {X: box, Y: place}
    rules:
      - references: {Z: {type: place, such_that: ["At(X, Z)"]}}
        context: ["near(Z, Y)", not Open(X)]
        outcomes:
          - {probability: 0.75, effects: ["At(X, Y)", "not At(X, Z)"]}
          - probability: 0.125
            effects:
              - {each: {U: box}, where: ["At(U, Z)"], then: [Open(U)]}
        noise: 0.125
  Back:
    arguments: {X: box, Y: place}
    agents: [robot]
    undoes: Move
    rules: []
)yaml";
constexpr char kGoals[] = "goals: {done: [\"At(_, p2)\", Calm()]}\n";

// What others read: how predicates are sensed.
void ReadOtherBlocks(const Config& config) {
  for (const auto& [name, node] : config["predicates"].Entries()) {
    if (node.Has("geometry")) node["geometry"].Entries();
  }
}

Domain Load(const std::string& text) {
  const Config config = Config::Parse(text, "d.yaml");
  Domain domain = Domain::FromConfig(config, PartTable());
  ReadOtherBlocks(config);
  config.Finish();
  return domain;
}

Domain Whole() {
  return Load(std::string(kTypes) + kPredicates + kActions + kGoals);
}

std::string ErrorOf(const std::string& text) {
  try {
    Load(text);
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "no error";
}

std::string ErrorWith(const std::string& what, const std::string& instead) {
  std::string text = std::string(kTypes) + kPredicates + kActions + kGoals;
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), instead);
  return ErrorOf(text);
}

int Atom(const Domain& domain, const std::string& name) {
  for (int i = 0; i < domain.vocabulary().num_atoms(); ++i) {
    if (domain.vocabulary().AtomName(i) == name) return i;
  }
  ADD_FAILURE() << "no atom " << name;
  return -1;
}

State With(const Domain& domain, const std::vector<std::string>& atoms) {
  State state(domain.vocabulary().num_atoms());
  for (const auto& name : atoms) state.Set(Atom(domain, name), Truth::kTrue);
  return state;
}

TEST(Domain, GroundAtomsStandInTheOrderOfTheirNames) {
  const Domain domain = Whole();
  std::vector<std::string> names;
  for (int i = 0; i < domain.vocabulary().num_atoms(); ++i) {
    names.push_back(domain.vocabulary().AtomName(i));
  }
  EXPECT_THAT(
      names, ElementsAre("At(b1, p1)", "At(b1, p2)", "At(b2, p1)", "At(b2, p2)",
                         "Calm()", "Open(b1)", "Open(b2)"));
}

TEST(Domain, AtomIndexIsTheInverseOfAtom) {
  const Domain domain = Whole();
  const Vocabulary& v = domain.vocabulary();
  for (int i = 0; i < v.num_atoms(); ++i) {
    const GroundAtom atom = v.Atom(i);
    EXPECT_EQ(v.AtomIndex(atom.predicate, atom.objects), i);
  }
  const int place = *v.FindObject("p1");
  EXPECT_EQ(v.AtomIndex(*v.FindPredicate("Open"), std::vector{place}),
            std::nullopt);
  EXPECT_THROW(v.AtomIndex(*v.FindPredicate("At"), std::vector{place}),
               std::invalid_argument);
  EXPECT_THROW(v.Atom(v.num_atoms()), std::out_of_range);
}

TEST(Domain, GroundActionsHoldObjectsOfTheArgumentsTypes) {
  const Domain domain = Whole();
  std::vector<std::string> names;
  for (const GroundAction& a : domain.GroundActions(Agent::kPerson)) {
    names.push_back(domain.Show(a));
  }
  EXPECT_THAT(names, ElementsAre("Move(b1, p1)", "Move(b1, p2)", "Move(b2, p1)",
                                 "Move(b2, p2)"));
  EXPECT_TRUE(domain.FindGroundAction("Move", {"b1", "p1"}).has_value());
  EXPECT_FALSE(domain.FindGroundAction("Move", {"p1", "b1"}).has_value());
  EXPECT_FALSE(domain.FindGroundAction("Move", {"b1"}).has_value());
  EXPECT_FALSE(domain.FindGroundAction("Fly", {"b1", "p1"}).has_value());
}

TEST(Domain, AnActionKnowsWhatItUndoes) {
  const Domain domain = Whole();
  const int back = *domain.FindAction("Back");
  EXPECT_EQ(domain.actions()[back].undoes, domain.FindAction("Move"));
  EXPECT_FALSE(domain.actions()[back].MayBeDoneBy(Agent::kPerson));
}

TEST(Domain, AnActionThatIsPutReplacesTheOneOfItsNameOrIsAppended) {
  Domain domain = Whole();
  Action move = domain.actions()[0];
  EXPECT_FALSE(domain.Put(move));
  move.rules.clear();
  EXPECT_TRUE(domain.Put(move));
  EXPECT_THAT(domain.actions()[0].rules, IsEmpty());
  EXPECT_EQ(domain.actions().size(), 2u);
  move.name = "Shove";
  EXPECT_TRUE(domain.Put(move));
  EXPECT_EQ(domain.FindAction("Shove"), 2);
  EXPECT_EQ(domain.FindAction("Move"), 0);
}

TEST(Domain, ADeicticReferenceBindsTheOnlyObject) {
  const Domain domain = Whole();
  const Action& move = domain.actions()[0];
  const Vocabulary& v = domain.vocabulary();
  const Binding arguments = {*v.FindObject("b1"), *v.FindObject("p2")};
  const State state = With(domain, {"At(b1, p1)", "At(b2, p1)"});
  const auto covers =
      ApplicableRules(move, arguments, state, v, Agent::kPerson);
  ASSERT_EQ(covers.size(), 1u);
  EXPECT_EQ(Apply(move.rules[0].outcomes[0], covers[0].binding, state, v),
            With(domain, {"At(b1, p2)", "At(b2, p1)"}));
}

TEST(Domain, ARuleWithoutAUniqueReferenceDoesNotApply) {
  const Domain domain = Whole();
  const Action& move = domain.actions()[0];
  const Vocabulary& v = domain.vocabulary();
  const Binding arguments = {*v.FindObject("b1"), *v.FindObject("p2")};
  for (const State& state :
       {With(domain, {}), With(domain, {"At(b1, p1)", "At(b1, p2)"})}) {
    EXPECT_TRUE(
        ApplicableRules(move, arguments, state, v, Agent::kPerson).empty());
  }
}

TEST(Domain, AnEffectOnEachReachesAllOfWhichItsConditionHeld) {
  const Domain domain = Whole();
  const Action& move = domain.actions()[0];
  const Vocabulary& v = domain.vocabulary();
  const Binding arguments = {*v.FindObject("b1"), *v.FindObject("p2")};
  const State state = With(domain, {"At(b1, p1)", "At(b2, p1)"});
  const auto covers =
      ApplicableRules(move, arguments, state, v, Agent::kPerson);
  EXPECT_EQ(Apply(move.rules[0].outcomes[1], covers.at(0).binding, state, v),
            With(domain, {"At(b1, p1)", "At(b2, p1)", "Open(b1)", "Open(b2)"}));
}

TEST(Domain, AnyStandsForSomeObjectAndNegatedForNone) {
  const Domain domain = Whole();
  const Vocabulary& v = domain.vocabulary();
  const Config some = Config::Parse("\"At(_, p2)\"", "l");
  const Config none = Config::Parse("\"not At(_, p2)\"", "l");
  const Literal at = ParseLiteral(some, v, {});
  const Literal not_at = ParseLiteral(none, v, {});
  const State there = With(domain, {"At(b2, p2)"});
  const State elsewhere = With(domain, {"At(b2, p1)"});
  EXPECT_TRUE(MayHold(at, {}, there, v));
  EXPECT_FALSE(MayHold(not_at, {}, there, v));
  EXPECT_FALSE(MayHold(at, {}, elsewhere, v));
  EXPECT_TRUE(MayHold(not_at, {}, elsewhere, v));
  EXPECT_EQ(Show(not_at, {}, v), "not At(_, p2)");
}

TEST(Domain, WhatIsUnknownMayHoldEitherWayButMustNot) {
  const Domain domain = Whole();
  const Vocabulary& v = domain.vocabulary();
  State state = With(domain, {});
  state.Set(Atom(domain, "At(b1, p2)"), Truth::kUnknown);
  for (const char* text : {"\"At(_, p2)\"", "\"not At(_, p2)\""}) {
    const Literal literal = ParseLiteral(Config::Parse(text, "l"), v, {});
    EXPECT_TRUE(MayHold(literal, {}, state, v)) << text;
    EXPECT_FALSE(MustHold(literal, {}, state, v)) << text;
  }
}

TEST(Domain, ErrorsNameFileAndKey) {
  EXPECT_THAT(ErrorWith("crate: box", "crate: bx"),
              StartsWith("d.yaml:types.crate: the parent 'bx'"));
  EXPECT_THAT(ErrorWith("thing: object", "thing: crate"),
              HasSubstr("is its own ancestor"));
  EXPECT_THAT(ErrorWith("b1: box", "b1: bx"),
              StartsWith("d.yaml:constants.b1"));
  EXPECT_THAT(ErrorWith("[[p1, p2]]", "[[p1, b1]]"),
              HasSubstr("'b1' is not a place"));
  EXPECT_THAT(ErrorWith("arguments: [box]", "arguments: [bx]"),
              StartsWith("d.yaml:predicates.Open.arguments: there is no type"));
  EXPECT_THAT(ErrorWith("not Open(X)", "not Opn(X)"),
              StartsWith("d.yaml:actions.Move.rules[0].context[1]: there is "
                         "no predicate"));
  EXPECT_THAT(ErrorWith("not Open(X)", "not Open(W)"),
              HasSubstr("the variable 'W' is not known"));
  EXPECT_THAT(ErrorWith("not Open(X)", "\"Open(X, Y)\""),
              HasSubstr("takes 1 arguments, not 2"));
  EXPECT_THAT(ErrorWith("not Open(X)", "Open(Y)"),
              HasSubstr("'Y' is a place, not a box"));
  EXPECT_THAT(ErrorWith("not Open(X)", "Open(b9)"),
              HasSubstr("there is no object 'b9'"));
  EXPECT_THAT(ErrorWith("not Open(X)", "Open X"), HasSubstr("should read"));
  EXPECT_THAT(ErrorWith("probability: 0.75", "probability: 0.7"),
              HasSubstr("it must be 1"));
  EXPECT_THAT(ErrorWith("\"not At(X, Z)\"", "\"not At(X, Y)\""),
              HasSubstr("contradicts another effect"));
  EXPECT_THAT(ErrorWith("\"not At(X, Z)\"", "\"near(Y, Z)\""),
              HasSubstr("static"));
  EXPECT_THAT(ErrorWith("then: [Open(U)]", "then: [Open(_)]"),
              HasSubstr("must name its objects"));
  EXPECT_THAT(ErrorWith("undoes: Move", "undoes: Mve"),
              HasSubstr("there is no action 'Mve'"));
  EXPECT_THAT(ErrorWith("agents: [robot]", "agents: [cat]"),
              HasSubstr("neither person nor robot"));
  EXPECT_THAT(ErrorWith("noise: 0.125", "nois: 0.125"), HasSubstr("missing"));
  EXPECT_THAT(ErrorWith("agents:", "agent:"),
              StartsWith("d.yaml:actions.Back.agent: not known"));
  EXPECT_THAT(ErrorWith("Calm()", "Calm(X)"), HasSubstr("takes 0 arguments"));
}

TEST(Domain, LeavesTheBlocksOfOthersUnread) {
  const Config config = Config::Parse(
      std::string(kTypes) + kPredicates + kActions + kGoals, "d.yaml");
  Domain::FromConfig(config, PartTable());
  EXPECT_THROW(config.Finish(), ConfigError);
  ReadOtherBlocks(config);
  EXPECT_NO_THROW(config.Finish());
}

constexpr char kRobots[] = R"yaml(
types: {box: object, arm: object, place: object}
constants: {b1: box, left: arm, right: arm, p1: place}
predicates:
  Held: {arguments: [box, arm], reported: held}
  CanTake: {arguments: [arm, box], reported: reachable}
  In: {arguments: [box], geometry: {deep: 1}}
actions:
  Put:
    arguments: {X: box}
    skill: {name: insert, part: X, site: p1, arm: right}
    robot:
      - {context: ["Held(X, right)"], effects: ["not Held(X, right)"]}
      - {context: ["CanTake(right, X)"], effects: []}
    rules:
      - context: [not In(X)]
        outcomes: [{probability: 0.75, effects: [In(X)]}]
        noise: 0.25
  PutDown:
    arguments: {X: box, A: arm}
    agents: [robot]
    skill: {name: put_down, part: X, arm: A}
    rules: []
goals: {done: [In(b1)]}
)yaml";

std::string ErrorOfRobots(const std::string& what, const std::string& instead) {
  std::string text = kRobots;
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), instead);
  try {
    Load(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(DomainOfRobots, KnowsWhichPredicatesArmsReport) {
  const Domain domain = Load(kRobots);
  const Vocabulary& v = domain.vocabulary();
  EXPECT_EQ(v.predicates()[*v.FindPredicate("Held")].report,
            Predicate::Report::kHeld);
  EXPECT_EQ(v.predicates()[*v.FindPredicate("CanTake")].report,
            Predicate::Report::kReachable);
  EXPECT_FALSE(v.predicates()[*v.FindPredicate("In")].report.has_value());
}

TEST(DomainOfRobots, AddsWhatARobotNeedsToEachRuleAndLeavesThePersonAlone) {
  const Domain domain = Load(kRobots);
  const Action& put = domain.actions()[0];
  const Vocabulary& v = domain.vocabulary();
  const Binding b1 = {*v.FindObject("b1")};
  const State bare = With(domain, {});
  EXPECT_EQ(ApplicableRules(put, b1, bare, v, Agent::kPerson).size(), 1u);
  EXPECT_TRUE(ApplicableRules(put, b1, bare, v, Agent::kRobot).empty());
  const State near = With(domain, {"CanTake(right, b1)"});
  EXPECT_EQ(ApplicableRules(put, b1, near, v, Agent::kRobot).size(), 1u);
  const State held = With(domain, {"Held(b1, right)"});
  const auto covers = ApplicableRules(put, b1, held, v, Agent::kRobot);
  ASSERT_EQ(covers.size(), 1u);
  EXPECT_EQ(
      Apply(put.rules[covers[0].rule].outcomes[0], covers[0].binding, held, v),
      With(domain, {"In(b1)"}));
}

TEST(DomainOfRobots, BindsSkillsToObjects) {
  const Domain domain = Load(kRobots);
  const Vocabulary& v = domain.vocabulary();
  const int b1 = *v.FindObject("b1");
  EXPECT_EQ(domain.SkillOf(*domain.FindGroundAction("Put", {"b1"})),
            (GroundSkill{"insert",
                         {{"part", b1}, {"site", *v.FindObject("p1")}},
                         *v.FindObject("right")}));
  EXPECT_EQ(domain.SkillOf(*domain.FindGroundAction("PutDown", {"b1", "left"})),
            (GroundSkill{"put_down", {{"part", b1}}, *v.FindObject("left")}));
}

TEST(DomainOfRobots, RefusesWhatNoArmCouldDo) {
  EXPECT_THAT(ErrorOfRobots("name: insert, ", ""),
              HasSubstr("actions.Put.skill.name: missing"));
  EXPECT_THAT(ErrorOfRobots("site: p1", "site: p2"),
              HasSubstr("there is no object 'p2'"));
  EXPECT_THAT(ErrorOfRobots("part: X, site", "part: Y, site"),
              HasSubstr("the variable 'Y' is not known"));
  EXPECT_THAT(ErrorOfRobots("arm: right}", "arm: _}"),
              HasSubstr("must be one object"));
  EXPECT_THAT(ErrorOfRobots("arm: right}", "arm: right, speed: 1}"),
              HasSubstr("actions.Put.skill.speed: there is no object"));
  EXPECT_THAT(ErrorOfRobots("agents: [robot]", "agents: [person]"),
              HasSubstr("skill: the robot is not one of the action's agents"));
  EXPECT_THAT(ErrorOfRobots("reported: held", "reported: felt"),
              HasSubstr("'felt' is neither held nor reachable"));
  EXPECT_THAT(ErrorOfRobots("[box], geometry: {deep: 1}",
                            "[box], geometry: {deep: 1}, reported: held"),
              HasSubstr("two arguments"));
  EXPECT_THAT(ErrorOfRobots("reported: held", "reported: held, geometry: {}"),
              HasSubstr("no geometry"));
}

TEST(State, KeepsEveryAtomApart) {
  std::mt19937_64 random(5);
  State state(131);
  std::vector<Truth> expected(131, Truth::kFalse);
  for (int i = 0; i < 2000; ++i) {
    const int atom = static_cast<int>(random() % 131);
    expected[atom] = static_cast<Truth>(random() % 3);
    state.Set(atom, expected[atom]);
  }
  std::vector<int> unknown;
  for (int i = 0; i < 131; ++i) {
    EXPECT_EQ(state.Get(i), expected[i]);
    if (expected[i] == Truth::kUnknown) unknown.push_back(i);
  }
  EXPECT_EQ(state.UnknownAtoms(), unknown);
  EXPECT_FALSE(state.UnknownAsFalse().HasUnknown());
  EXPECT_THROW(state.Get(131), std::out_of_range);
}

TEST(State, EqualStatesHaveEqualHashesWhateverCameBefore) {
  State a(70);
  State b(70);
  a.Set(69, Truth::kUnknown);
  a.Set(3, Truth::kUnknown);
  a.Set(3, Truth::kTrue);
  b.Set(3, Truth::kTrue);
  b.Set(69, Truth::kTrue);
  b.Set(69, Truth::kUnknown);
  EXPECT_EQ(a, b);
  EXPECT_EQ(a.Hash(), b.Hash());
}

}  // namespace
}  // namespace cell
