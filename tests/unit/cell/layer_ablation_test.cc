#include "services/cell/evaluations/layer_ablation.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <vector>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using testing::HasSubstr;

// A part touches something and comes to be in `place` there; two actions that
// only the layer tells apart.
ShownChain Shown(const std::string& action, Place place) {
  EventChain chain;
  chain.Append({{{"base", "shaft"}, Relation::kNotTouching}});
  chain.Append({{{"base", "shaft"}, Relation::kTouching}});
  std::vector<RelationLayers> layers(2);
  layers[1].places[{"base", "shaft"}] = place;
  return {action, "shaft", "", chain, EnrichedRowsOf("shaft", chain, layers)};
}

std::vector<ShownChain> TwoActions() {
  std::vector<ShownChain> chains;
  for (int i = 0; i < 5; ++i) {
    chains.push_back(Shown("Insert", Place::kHolds));
    chains.push_back(Shown("Lay", Place::kCarries));
  }
  return chains;
}

TEST(AblateLayers, SeparationRisesWhereOnlyALayerTellsActionsApart) {
  const Task task = LoadTask(ShippedDeployment());
  const auto results = AblateLayers(TwoActions(), task, 1);
  ASSERT_EQ(results.size(), 8u);
  EXPECT_EQ(results[0].layers, "touching");
  EXPECT_EQ(results[0].separation.area, 0.5);
  EXPECT_EQ(results[0].num_right, 0);
  EXPECT_EQ(results[1].layers, "touching + static");
  EXPECT_EQ(results[1].separation.area, 1);
  EXPECT_EQ(results[1].gain.area, 0.5);
  EXPECT_EQ(results[1].gain_low.area, 0.5);
  EXPECT_EQ(results[1].num_right, 10);
  EXPECT_EQ(results[2].layers, "touching + dynamic");
  EXPECT_EQ(results[2].gain.area, 0);
  EXPECT_THAT(LayersToCsv(results, 1, 2), HasSubstr("1,2,typed,all,10,1.0"));
}

TEST(AblateLayers, NeedsSomethingAlikeAndSomethingElse) {
  const Task task = LoadTask(ShippedDeployment());
  EXPECT_THROW(AblateLayers({Shown("Lay", Place::kOn)}, task, 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace cell
