#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "common/planning/excuse.h"
#include "tests/unit/planning/ppddl_task.h"
#include "tests/unit/small_ppddl.h"

namespace cell::planning {
namespace {

bool IsNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// The text with other names, all at once.
std::string Renamed(const std::string& text,
                    const std::map<std::string, std::string>& names) {
  std::string renamed;
  for (size_t at = 0; at < text.size();) {
    size_t end = at;
    while (end < text.size() && IsNameCharacter(text[end])) ++end;
    if (end == at) {
      renamed += text[at++];
      continue;
    }
    const std::string word = text.substr(at, end - at);
    const auto it = names.find(word);
    renamed += it == names.end() ? word : it->second;
    at = end;
  }
  return renamed;
}

/// Names of the courier's world, in another alphabetical order each time.
std::map<std::string, std::string> OtherNames(uint64_t seed) {
  std::mt19937_64 random(seed);
  std::map<std::string, std::string> names;
  for (const char* name :
       {"depot", "m", "t", "x", "at", "road", "bridge", "broken", "in",
        "loaded", "drive", "cross", "load", "unload", "parcel", "place"}) {
    names[name] = std::string(1, static_cast<char>('a' + random() % 26)) +
                  std::to_string(random() % 100) + name + "0";
  }
  return names;
}

std::string Told(const GroundTask& task) {
  std::string text;
  for (const Excuse& excuse : FindExcuses(task).excuses) {
    text += Explain(excuse, task) + "\n";
    for (const Literal& l : excuse.subgoals) text += Show(l, task.atoms) + ";";
  }
  return text;
}

void ExpectSamePlans(const GroundTask& task, const GroundTask& other,
                     const std::map<std::string, std::string>& names) {
  Plan plan = PlanOf(task);
  const Plan renamed = PlanOf(other);
  for (Step& step : plan.course) step.name = Renamed(step.name, names);
  for (Alternative& a : plan.alternatives) a.name = Renamed(a.name, names);
  EXPECT_EQ(plan, renamed);
}

class Renaming : public testing::TestWithParam<uint64_t> {
 protected:
  const std::map<std::string, std::string> names_ = OtherNames(GetParam());
  GroundTask Task(const std::string& problem, bool is_renamed,
                  ConstantAtoms constants) const {
    const auto text = [&](const std::string& t) {
      return is_renamed ? Renamed(t, names_) : t;
    };
    return TaskOf(text(kCourier), text(problem), constants);
  }
};

TEST_P(Renaming, ChangesNothingButNamesInPlans) {
  const auto constants = ConstantAtoms::kReplace;
  for (const std::string& problem :
       {std::string(kDelivery), With(kDelivery, "(bridge m t)",
                                     "(bridge m t) (bridge t m) (road m t)")}) {
    ExpectSamePlans(Task(problem, false, constants),
                    Task(problem, true, constants), names_);
  }
}

TEST_P(Renaming, ChangesNothingButNamesInExcuses) {
  const std::string broken =
      With(kDelivery, "(at depot)", "(at depot) (broken)");
  const std::string apart = With(kDelivery, "(road depot m)", "");
  for (const std::string& problem : {broken, apart}) {
    const std::string told = Told(Task(problem, false, ConstantAtoms::kKeep));
    EXPECT_NE(told, "");
    EXPECT_EQ(Renamed(told, names_),
              Told(Task(problem, true, ConstantAtoms::kKeep)));
  }
}

INSTANTIATE_TEST_SUITE_P(Names, Renaming, testing::Range<uint64_t>(0, 8));

}  // namespace
}  // namespace cell::planning
