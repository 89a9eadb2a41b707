#include "common/sec/chain_clustering.h"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

#include "common/sec/similarity_cut.h"
#include "common/sec/typed_similarity.h"
#include "tests/unit/sec/matrix_testing.h"

namespace cell {
namespace {

using testing::ElementsAre;

TEST(OtsuCut, LiesBetweenTwoGroups) {
  const std::vector<double> similarities = {0.1, 0.15, 0.2, 0.12, 0.8, 0.85};
  const double cut = OtsuCut(similarities);
  EXPECT_GT(cut, 0.2);
  EXPECT_LT(cut, 0.8);
  EXPECT_DOUBLE_EQ(MeanFrom(cut, similarities), 0.825);
}

TEST(OtsuCut, IsTheBorderOfLargestVarianceBetweenGroups) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    // Middles of bins, so that the histogram loses nothing.
    std::vector<double> values;
    for (int i = 0; i < 30; ++i) {
      values.push_back((static_cast<double>(DrawBelow(50, random)) + 0.5) / 50);
    }
    const auto variance_at = [&](double cut) {
      double low = 0, sum_low = 0, high = 0, sum_high = 0;
      for (const double value : values) {
        (value < cut ? low : high) += 1;
        (value < cut ? sum_low : sum_high) += value;
      }
      if (low == 0 || high == 0) return 0.0;
      const double apart = sum_low / low - sum_high / high;
      return low * high * apart * apart;
    };
    double best = 0;
    for (int bin = 0; bin <= 50; ++bin) {
      best = std::max(best, variance_at(bin / 50.0));
    }
    EXPECT_NEAR(variance_at(OtsuCut(values)), best, 1e-9);
  }
}

TEST(OtsuCut, IsZeroWithoutTwoGroups) {
  EXPECT_EQ(OtsuCut({}), 0);
  EXPECT_EQ(OtsuCut(std::vector<double>{0.5, 0.5}), 0);
  EXPECT_EQ(MeanFrom(0.3, {}), 0.3);
}

TEST(HighestCut, DividesAgainWhatIsTwoGroups) {
  std::vector<double> similarities;
  for (const double group : {0.3, 0.75, 0.97}) {
    for (int i = 0; i < 20; ++i) similarities.push_back(group + 0.001 * i);
  }
  EXPECT_LT(OtsuCut(similarities), 0.75);
  EXPECT_GT(HighestCut(similarities), 0.77);
  EXPECT_LT(HighestCut(similarities), 0.97);
}

TEST(HighestCut, IsOtsusIfTheHighOnesAreOneGroup) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> low(0.3, 0.05), high(0.75, 0.07);
  std::vector<double> similarities;
  for (int i = 0; i < 300; ++i) {
    similarities.push_back(low(random));
    similarities.push_back(high(random));
  }
  EXPECT_DOUBLE_EQ(HighestCut(similarities), OtsuCut(similarities));
  EXPECT_EQ(HighestCut({}), 0);
}

RelationMatrix Original() {
  return MatrixOf({"91119", "90109", "11011"});
}

TEST(ChainModel, LearnsByMajorityWhatNoiseHidesInEverySample) {
  std::mt19937_64 random(2);
  ChainModel model(WithNoise(Original(), {0.15}, random), {});
  for (int i = 1; i < 60; ++i) {
    model.Update(WithNoise(Original(), {0.15}, random));
  }
  EXPECT_EQ(model.num_samples(), 60);
  EXPECT_EQ(model.Consensus().Sorted(), Original());
}

TEST(ChainModel, AppendsNewRowsAndColumnsAndDeletesThoseThatStayLight) {
  const RelationMatrix with_noise =
      MatrixOf({"912119", "900109", "112011", "012902"}, {0, 1, 2, 3});
  ChainModel model(Original(), {});
  model.Update(with_noise);
  EXPECT_EQ(model.chain().num_rows(), 4u);
  EXPECT_EQ(model.chain().num_columns(), 6u);
  for (int i = 2; i < 10; ++i) model.Update(Original());
  EXPECT_EQ(model.chain().num_rows(), 4u) << "still on trial";
  model.Update(Original());
  EXPECT_EQ(model.chain(), Original());
}

TEST(ChainModel, KeepsALineThatSamplesShowOftenEnough) {
  const RelationMatrix wider =
      MatrixOf({"91119", "90109", "11011", "02220"}, {0, 1, 2, 3});
  ChainModel model(Original(), {});
  for (int i = 0; i < 20; ++i) model.Update(i % 3 != 2 ? wider : Original());
  EXPECT_EQ(model.chain().num_rows(), 4u);
}

TEST(ChainModel, OfTwoMergedHasTheSamplesAndLinesOfBoth) {
  const RelationMatrix wider =
      MatrixOf({"91119", "90109", "11011", "02220"}, {0, 1, 2, 3});
  ChainModel model(Original(), {});
  model.Update(Original());
  ChainModel other(wider, {});
  model.Merge(other);
  EXPECT_EQ(model.num_samples(), 3);
  EXPECT_EQ(model.chain().num_rows(), 4u);
  EXPECT_EQ(model.Consensus().num_rows(), 3u);
}

ChainClustering::Params WithTyped() {
  ChainClustering::Params params;
  params.similarity = std::make_shared<TypedSimilarity>();
  return params;
}

TEST(ChainClustering, TellsThreeManipulationsApartOnline) {
  std::mt19937_64 random(3);
  std::vector<RelationMatrix> classes;
  for (int i = 0; i < 3; ++i) {
    classes.push_back(RandomChain({0, 1, 2, 3, 0}, 6, random));
  }
  ChainClustering clustering(WithTyped());
  for (size_t i = 0; i < 60; ++i) {
    clustering.Add(WithNoise(classes[i % 3], {0.1}, random));
  }
  ASSERT_EQ(clustering.clusters().size(), 3u);
  for (const auto& cluster : clustering.clusters()) {
    std::set<size_t> labels;
    for (const size_t sample : cluster.samples) labels.insert(sample % 3);
    EXPECT_EQ(labels.size(), 1u);
    EXPECT_EQ(cluster.samples.size(), 20u);
    EXPECT_EQ(cluster.model.num_samples(), 20);
  }
}

TEST(ChainClustering, MergesModelsThatBecomeAlike) {
  // Far apart at first; samples in between bring them together.
  const RelationMatrix a = MatrixOf({"0000011111"});
  const RelationMatrix b = MatrixOf({"0000099999"});
  ChainClustering::Params params = WithTyped();
  params.first_threshold = 0.65;
  ChainClustering clustering(params);
  clustering.Add(a);
  clustering.Add(b);
  ASSERT_EQ(clustering.clusters().size(), 2u);
  for (int i = 0; i < 4; ++i) clustering.Add(MatrixOf({"0000011199"}));
  ASSERT_EQ(clustering.clusters().size(), 1u);
  EXPECT_THAT(clustering.clusters()[0].samples, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(ChainClustering, ByTauSplitsMoreThanByTheCut) {
  ChainClustering::Params by_tau = WithTyped();
  by_tau.threshold = ChainClustering::Threshold::kMeanOfHigh;
  ChainClustering cut(WithTyped()), tau(by_tau);
  std::mt19937_64 random(4);
  const RelationMatrix other = RandomChain({0, 1, 2}, 5, random);
  for (int i = 0; i < 80; ++i) {
    const auto sample =
        WithNoise(i % 2 == 0 ? Original() : other, {0.1}, random);
    cut.Add(sample);
    tau.Add(sample);
  }
  EXPECT_EQ(cut.clusters().size(), 2u);
  EXPECT_GT(tau.clusters().size(), 2u);
  EXPECT_GT(tau.threshold(), OtsuCut(tau.similarities()));
}

TEST(ChainClustering, RefusesWhatItCannotCompare) {
  EXPECT_THROW(ChainClustering({}), std::invalid_argument);
  ChainClustering clustering(WithTyped());
  EXPECT_THROW(clustering.Add(RelationMatrix()), std::invalid_argument);
  EXPECT_TRUE(clustering.clusters().empty());
}

}  // namespace
}  // namespace cell
