#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "common/parts/part_table.h"
#include "common/relational/domain.h"
#include "common/relational/rule_set.h"
#include "services/planner/arm_states.h"

namespace cell {

// What every bench has: its types and predicates, and how the left arm hands a
// part over.
inline const std::string kBenchTypes =
    "types: {part: object, bolt: part, lid: part, hole: object, arm: object}\n";
inline const std::string kBenchPredicates = R"yaml(
predicates:
  Held: {arguments: [part, arm], reported: held}
  Reachable: {arguments: [arm, part], reported: reachable}
  In: {arguments: [bolt, hole]}
  Closed: {arguments: [lid]}
)yaml";
inline const std::string kPresentOfBench = R"yaml(
  Present:
    arguments: {X: part}
    agents: [robot]
    skill: {name: present, part: X, arm: left}
    rules:
      - context: ["Reachable(left, X)", "not Held(_, left)",
                  "not Reachable(right, X)"]
        outcomes: [{probability: 0.9, effects: ["Reachable(right, X)"]}]
        noise: 0.1
)yaml";

// Two bolts and a lid over them; the right arm inserts, the left hands over.
inline const std::string kBench = kBenchTypes + R"yaml(
constants: {bolt_1: bolt, bolt_2: bolt, lid: lid, hole_1: hole, hole_2: hole,
            top: object, left: arm, right: arm}
)yaml" + kBenchPredicates + R"yaml(
actions:
  Insert:
    arguments: {X: bolt, Y: hole}
    skill: {name: insert, part: X, site: Y, arm: right}
    robot: &right
      - {context: ["Held(X, right)"], effects: ["not Held(X, right)"]}
      - {context: ["Reachable(right, X)", "not Held(_, right)"], effects: []}
    rules:
      - context: ["not In(X, _)", "not In(_, Y)", not Closed(_)]
        outcomes: [{probability: 0.9, effects: ["In(X, Y)"]}]
        noise: 0.1
  Close:
    arguments: {X: lid}
    skill: {name: insert, part: X, site: top, arm: right}
    robot: *right
    rules:
      - context: ["In(_, hole_1)", "In(_, hole_2)", not Closed(X)]
        outcomes: [{probability: 0.9, effects: [Closed(X)]}]
        noise: 0.1
)yaml" + kPresentOfBench + R"yaml(
  PutDown:
    arguments: {X: part, A: arm}
    agents: [robot]
    skill: {name: put_down, part: X, arm: A}
    rules:
      - context: ["Held(X, A)"]
        outcomes: [{probability: 0.9, effects: ["not Held(X, A)"]}]
        noise: 0.1
goals:
  done: [Closed(lid)]
  one: ["In(_, hole_1)"]
)yaml";

/// The bench's rules and goals, and its objects and atoms by name.
struct BenchDomain {
  explicit BenchDomain(const std::string& text = kBench, int64_t version = 1)
      : domain(Domain::FromConfig(Config::Parse(text, "bench"), PartTable())),
        rules(RuleSet::FromDomain(domain, "bench", version)) {}

  const Goal& GoalOf(const std::string& name) const {
    return *domain.FindGoal(name);
  }
  int Object(const std::string& name) const {
    return rules->vocabulary().FindObject(name).value();
  }
  std::string Name(int object) const {
    return rules->vocabulary().objects()[object].name;
  }
  GroundAction Action(const std::string& name,
                      const std::vector<std::string>& objects) const {
    return rules->FindGroundAction(name, objects).value();
  }
  State StateOf(const std::set<std::string>& is_true,
                const std::set<std::string>& is_unknown = {}) const {
    const Vocabulary& vocabulary = rules->vocabulary();
    State state(vocabulary.num_atoms());
    for (int i = 0; i < state.num_atoms(); ++i) {
      const std::string name = vocabulary.AtomName(i);
      if (is_true.contains(name)) state.Set(i, Truth::kTrue);
      if (is_unknown.contains(name)) state.Set(i, Truth::kUnknown);
    }
    return state;
  }

  Domain domain;
  std::shared_ptr<const RuleSet> rules;
};

/// What arms at the bench report of their skills.
inline std::map<std::string, planner::SkillTraits> SkillsOfBench() {
  return {{"insert", {}},
          {"present", {.may_run_beside = true, .hands_over = true}},
          {"put_down", {}}};
}

/// The bench's text with a part of it replaced.
inline std::string BenchWith(const std::string& part,
                             const std::string& other) {
  std::string text = kBench;
  const size_t place = text.find(part);
  if (place == std::string::npos) {
    ADD_FAILURE() << "the bench does not say " << part;
    return text;
  }
  return text.replace(place, part.size(), other);
}

}  // namespace cell
