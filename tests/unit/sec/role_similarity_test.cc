#include "common/sec/role_similarity.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/unit/sec/shown_library.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RoleSimilarityTest : public ShownLibrary {
 protected:
  RoleSimilarity Roles() const { return {models_, words_, *chains_}; }
  double OfTypes(const std::string& a, const std::string& b) const {
    const auto types = Roles().Types();
    const auto place = [&](const std::string& type) {
      const auto found = std::ranges::find(types, type);
      EXPECT_NE(found, types.end()) << type;
      return static_cast<size_t>(found - types.begin());
    };
    return Roles().OfTypes()[place(a)][place(b)];
  }
};

TEST_F(RoleSimilarityTest, IsSymmetricAndOneWithItself) {
  for (const auto& matrix : {Roles().OfActions(), Roles().OfTypes()}) {
    for (size_t i = 0; i < matrix.size(); ++i) {
      EXPECT_DOUBLE_EQ(matrix[i][i], 1);
      for (size_t j = 0; j < matrix.size(); ++j) {
        EXPECT_DOUBLE_EQ(matrix[i][j], matrix[j][i]);
        EXPECT_GE(matrix[i][j], 0);
        EXPECT_LE(matrix[i][j], 1);
      }
    }
  }
}

TEST_F(RoleSimilarityTest, ObjectsOfOneRoleAreAlikeWhateverTheirTypes) {
  EXPECT_DOUBLE_EQ(OfTypes("round_peg", "shaft"), 1);
  EXPECT_GT(OfTypes("round_peg", "square_peg"), 0.9);
  EXPECT_GT(OfTypes("round_hole", "square_hole"), 0.7);
  EXPECT_LT(OfTypes("round_peg", "round_hole"), 0.1) << "moved, and not";
  EXPECT_LT(OfTypes("round_peg", "separator"), 0.5);
  EXPECT_LT(OfTypes("head", "pendulum"), 0.5);
}

TEST_F(RoleSimilarityTest, WhatHasNoActionOfItsOwnStandsInWhereItFits) {
  EXPECT_THAT(Roles().AllStandIns(), IsEmpty());
  LearnedModel& model = models_.at("PlaceRoundPeg");
  model.roles[0].type = *words_.vocabulary.types().Find("shaft");
  EXPECT_THAT(
      Roles().AllStandIns(),
      ElementsAre(RoleSimilarity::StandIn{"round_peg_1", "PlaceRoundPeg"},
                  RoleSimilarity::StandIn{"round_peg_2", "PlaceRoundPeg"}));
}

TEST(RoleGroups, AreTheConnectedComponents) {
  const std::vector<std::vector<double>> chain = {
      {1, 0, 0.7, 0}, {0, 1, 0, 0.2}, {0.7, 0, 1, 0}, {0, 0.2, 0, 1}};
  EXPECT_THAT(GroupsOf(chain, 0.6),
              ElementsAre(ElementsAre(0, 2), ElementsAre(1), ElementsAre(3)));
  EXPECT_THAT(GroupsOf(chain, 0.1),
              ElementsAre(ElementsAre(0, 2), ElementsAre(1, 3)));
}

}  // namespace
}  // namespace cell
