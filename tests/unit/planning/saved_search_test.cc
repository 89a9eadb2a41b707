#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/planning/planner.h"
#include "tests/unit/ladder_ppddl.h"
#include "tests/unit/planning/ppddl_task.h"
#include "tests/unit/small_ppddl.h"

namespace cell::planning {
namespace {

using Progress = Planner::Progress;

/// A search in parts, each of one pass and in a planner of its own.
struct SearchInParts {
  Plan plan;
  int num_parts = 0;
};

std::unique_ptr<Planner> Restored(const std::shared_ptr<GroundModel>& model,
                                  const Planner::Params& params,
                                  const std::string& saved) {
  auto planner = std::make_unique<Planner>(model, params);
  std::istringstream in(saved);
  if (!saved.empty()) planner->Restore(&in, saved.size());
  return planner;
}

SearchInParts SearchPassByPass(const std::shared_ptr<GroundModel>& model,
                               const Planner::Params& params) {
  SearchInParts search;
  std::string saved;
  for (bool is_stopped = true; is_stopped; ++search.num_parts) {
    const auto planner = Restored(model, params, saved);
    is_stopped = false;
    search.plan = planner->Find(model->initial(), [&](const Progress& now) {
      if (now.is_last) return true;
      std::ostringstream out;
      planner->Save(&out);
      saved = out.str();
      is_stopped = true;
      return false;
    });
  }
  return search;
}

std::string SaveAfter(int64_t max_expansions,
                      const std::shared_ptr<GroundModel>& model) {
  Planner::Params params;
  params.max_expansions = max_expansions;
  Planner planner(model, params);
  std::string saved;
  planner.Find(model->initial(), [&](const Progress& now) {
    if (now.is_last) {
      std::ostringstream out;
      planner.Save(&out);
      saved = out.str();
    }
    return true;
  });
  return saved;
}

TEST(SavedSearch, InterruptedAfterEveryPassFindsTheSame) {
  for (const int length : {3, 6, 9}) {
    const auto model =
        std::make_shared<GroundModel>(TaskOf(kRover, LadderProblem(length)));
    const Plan whole = Planner(model, {}).Find(model->initial());
    const SearchInParts search = SearchPassByPass(model, {});
    EXPECT_EQ(search.plan, whole) << length;
    EXPECT_GT(search.num_parts, 3) << length;
    EXPECT_TRUE(whole.is_shortest);
  }
}

TEST(SavedSearch, ASpentBudgetCanBeRaised) {
  const auto model =
      std::make_shared<GroundModel>(TaskOf(kRover, LadderProblem(9)));
  const Plan whole = Planner(model, {}).Find(model->initial());
  const int64_t half = whole.num_expansions / 2;
  const auto planner = Restored(model, {}, SaveAfter(half, model));
  const Plan plan = planner->Find(model->initial());
  EXPECT_NEAR(plan.probability.low, whole.probability.low, 1e-9);
  EXPECT_NEAR(plan.expected_actions, whole.expected_actions, 1e-6);
  EXPECT_TRUE(plan.is_shortest);
  EXPECT_GT(plan.num_expansions, half);  // all of them, from the beginning
}

TEST(SavedSearch, TheProofOfTheFewestActionsCanFollow) {
  const auto model =
      std::make_shared<GroundModel>(TaskOf(kRover, LadderProblem(9)));
  const Plan whole = Planner(model, {}).Find(model->initial());
  Planner::Params params;
  params.max_minimize_expansions = 0;
  Planner planner(model, params);
  std::ostringstream out;
  const Plan first = planner.Find(model->initial(), [&](const Progress& now) {
    if (now.is_last) planner.Save(&out);
    return true;
  });
  EXPECT_FALSE(first.is_shortest);
  EXPECT_NEAR(first.probability.low, whole.probability.low, 1e-9);
  EXPECT_GE(first.expected_actions, whole.expected_actions - 1e-6);
  EXPECT_LT(first.num_expansions, whole.num_expansions);
  EXPECT_EQ(Restored(model, {}, out.str())->Find(model->initial()), whole);
}

TEST(SavedSearch, DamageIsRefused) {
  const auto model = std::make_shared<GroundModel>(TaskOf(kCourier, kDelivery));
  const std::string saved = SaveAfter(100, model);
  for (size_t i = 0; i < saved.size(); i += 7) {
    std::string damaged = saved;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x40);
    EXPECT_THROW(Restored(model, {}, damaged), std::runtime_error) << i;
    if (i == 0) continue;
    EXPECT_THROW(Restored(model, {}, saved.substr(0, i)), std::runtime_error)
        << i;
  }
}

TEST(SavedSearch, AnotherStartIsRefused) {
  const auto model = std::make_shared<GroundModel>(TaskOf(kCourier, kDelivery));
  const auto planner = Restored(model, {}, SaveAfter(100, model));
  std::vector<uint64_t> other = model->initial();
  other[0] ^= 1;
  EXPECT_THROW(planner->Find(other), std::invalid_argument);
}

}  // namespace
}  // namespace cell::planning
