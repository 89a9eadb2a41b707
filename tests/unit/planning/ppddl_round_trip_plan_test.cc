#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/unit/planning/ppddl_task.h"
#include "tests/unit/small_ppddl.h"

namespace cell::planning {
namespace {

/// A delivery among towns with random roads and bridges.
std::string RandomDelivery(uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::vector<std::string> towns = {"depot", "m", "t", "u"};
  std::string init = "(at depot) (in x depot)";
  for (const std::string& from : towns) {
    for (const std::string& to : towns) {
      if (from == to || random() % 3 == 0) continue;
      init +=
          (random() % 2 == 0 ? " (road " : " (bridge ") + from + " " + to + ")";
    }
  }
  return "(define (problem p) (:domain courier) (:objects m t u - town x - "
         "parcel) (:init " +
         init + ") (:goal (and (in x t) " +
         (random() % 2 == 0 ? "(not (broken))" : "(or (at m) (at u))") + ")))";
}

TEST(PpddlRoundTrip, GivesTheSameTasksAndPlans) {
  int num_found = 0;
  for (uint64_t seed = 0; seed < 40; ++seed) {
    const std::string text = RandomDelivery(seed);
    const auto domain = ppddl::ParseDomain(kCourier, "d");
    const auto problem = ppddl::ParseProblem(text, "p", domain);
    const std::string domain_text = ToText(domain);
    const std::string problem_text = ToText(problem, domain);
    EXPECT_EQ(ppddl::ParseDomain(domain_text, "d"), domain);
    EXPECT_EQ(ppddl::ParseProblem(problem_text, "p", domain), problem);
    const GroundTask task = TaskOf(kCourier, text);
    const GroundTask written = TaskOf(domain_text, problem_text);
    EXPECT_EQ(task, written) << text;
    const Plan plan = PlanOf(task);
    EXPECT_EQ(plan, PlanOf(written));
    num_found += plan.status == Plan::Status::kFound;
  }
  EXPECT_GT(num_found, 10);
  EXPECT_LT(num_found, 40);
}

}  // namespace
}  // namespace cell::planning
