#include "services/sec_builder/pair_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cell {

using namespace sec_builder;
namespace {

constexpr int64_t kFramePeriod = 96'000;

// Changes that a series of distances [mm] gives, one frame each.
std::vector<PairFilter::Change> Changes(const std::vector<double>& distances,
                                        int confirm_frames = 2,
                                        int64_t start = 0) {
  PairFilter filter({.confirm_frames = confirm_frames});
  filter.Start({distances.front() * 1e-3});
  std::vector<PairFilter::Change> changes;
  for (size_t i = 0; i < distances.size(); ++i) {
    const int64_t utime = start + kFramePeriod * static_cast<int64_t>(i);
    if (const auto change = filter.Update(utime, {distances[i] * 1e-3})) {
      changes.push_back(*change);
    }
  }
  return changes;
}

TEST(PairFilter, AChangeIsDatedBackToTheFirstFrameThatShowedIt) {
  const auto changes = Changes({20, 15, 3.9, 3, 2, 9, 11, 12});
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].relation, Relation::kTouching);
  EXPECT_EQ(changes[0].onset, 2 * kFramePeriod);
  EXPECT_EQ(changes[1].relation, Relation::kNotTouching);
  EXPECT_EQ(changes[1].onset, 6 * kFramePeriod);
}

TEST(PairFilter, AReleaseIsDatedBackToTheFirstCrossingIfThatWasNotLongAgo) {
  const auto onset_of_release = [](int num_between, int64_t backdate_us) {
    PairFilter filter({.confirm_frames = 2, .backdate_us = backdate_us});
    filter.Start({0.001});
    int64_t utime = 0;
    for (int i = 0; i < num_between; ++i) {
      EXPECT_FALSE(filter.Update(utime += kFramePeriod, {0.007}));
      const bool may_come = kFramePeriod * i < backdate_us;
      EXPECT_EQ(filter.pending_since(utime).has_value(), may_come) << i;
    }
    filter.Update(utime += kFramePeriod, {0.011});
    return filter.Update(utime += kFramePeriod, {0.012})->onset / kFramePeriod;
  };
  EXPECT_EQ(onset_of_release(3, 0), 4);
  EXPECT_EQ(onset_of_release(3, 3 * kFramePeriod), 1);
  EXPECT_EQ(onset_of_release(3, 2 * kFramePeriod), 4);
  EXPECT_EQ(onset_of_release(0, 3 * kFramePeriod), 1);
}

TEST(PairFilter, BetweenTheThresholdsNothingChanges) {
  EXPECT_TRUE(Changes({0, 4.1, 9.9, 4.1, 9.9, 0, 9.9}).empty());
  EXPECT_TRUE(Changes({20, 4.1, 9.9, 4.1, 20, 4.1}).empty());
}

TEST(PairFilter, ShorterThanTheConfirmationIsFlicker) {
  for (const int frames : {2, 3, 5}) {
    std::vector<double> distances(4, 20.0);
    distances.insert(distances.end(), static_cast<size_t>(frames - 1), 0.0);
    distances.insert(distances.end(), 10, 20.0);
    EXPECT_TRUE(Changes(distances, frames).empty()) << frames;
    distances[3] = 0;
    EXPECT_EQ(Changes(distances, frames).size(), 2u) << frames;
  }
}

// Property: only differences of stamps matter.
TEST(PairFilter, IsInvariantToATimeShift) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> distance(0, 20);
  std::vector<double> distances(500);
  for (double& d : distances) d = distance(random);
  const auto reference = Changes(distances);
  EXPECT_GT(reference.size(), 10u);
  for (const int64_t shift : {int64_t{1}, int64_t{1'700'000'000'000'000}}) {
    const auto shifted = Changes(distances, 2, shift);
    ASSERT_EQ(shifted.size(), reference.size());
    for (size_t i = 0; i < reference.size(); ++i) {
      EXPECT_EQ(shifted[i].onset - shift, reference[i].onset);
      EXPECT_EQ(shifted[i].relation, reference[i].relation);
    }
  }
}

// Property: relations alternate, whatever is seen.
TEST(PairFilter, EveryChangeChangesSomething) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  PairFilter filter({});
  filter.Start({0.02});
  Relation relation = filter.relation();
  for (int i = 0; i < 5000; ++i) {
    const auto change =
        filter.Update(kFramePeriod * i,
                      {std::abs(unit(random)) * 0.015, unit(random) * 0.01});
    if (!change) continue;
    EXPECT_NE(change->relation, relation);
    relation = change->relation;
    EXPECT_EQ(filter.relation(), relation);
  }
}

// Facts on key frames from poses at 10 Hz: noise correlated over frames.
int FalseChanges(double truth_mm, double sigma_mm, int confirm_frames,
                 int num_frames) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const double memory = 0.5;
  double noise = 0;
  std::vector<double> distances;
  for (int i = 0; i < num_frames; ++i) {
    noise = memory * noise +
            std::sqrt(1 - memory * memory) * sigma_mm * normal(random);
    distances.push_back(std::max(0.0, truth_mm + noise));
  }
  distances[0] = truth_mm;
  return static_cast<int>(Changes(distances, confirm_frames).size());
}

TEST(PairFilter, NoiseOfThreeMillimetresAtRestGivesNoFalseChange) {
  EXPECT_EQ(FalseChanges(0, 3, 5, 60 * 600), 0);
}

TEST(PairFilter, MoreFramesGiveFewerFalseTouchesInANearMiss) {
  constexpr int kMinute = 600, kMinutes = 30;
  const double two = FalseChanges(6, 2, 2, kMinutes * kMinute);
  const double five = FalseChanges(6, 2, 5, kMinutes * kMinute);
  EXPECT_LT(five, two / 4);
  EXPECT_LT(five / kMinutes, 1);
}

TEST(PairFilter, ContainmentHasItsOwnHysteresis) {
  PairFilter filter({.confirm_frames = 1});
  filter.Start({0, -0.02});
  EXPECT_EQ(filter.relation(), Relation::kTouching);
  EXPECT_FALSE(filter.Update(0, {0, -0.001}));
  EXPECT_EQ(filter.Update(1, {0, 0.001})->relation, Relation::kOverlapping);
  EXPECT_FALSE(filter.Update(2, {0, -0.005}));
  EXPECT_EQ(filter.Update(3, {0, -0.007})->relation, Relation::kTouching);
}

TEST(PairFilter, WhatIsHiddenHoldsAndDoesNotConfirm) {
  PairFilter filter({.confirm_frames = 2});
  filter.Start({0});
  filter.Update(0, {0.02});
  filter.Hide();
  EXPECT_FALSE(filter.pending_since(0));
  EXPECT_FALSE(filter.Update(2, {0.02}));
  EXPECT_EQ(filter.relation(), Relation::kTouching);
  EXPECT_EQ(filter.Update(3, {0.02})->onset, 2);
}

TEST(PairFilter, WhatIsLostIsAbsentAtOnceAndOnce) {
  PairFilter filter({});
  filter.Start({0});
  EXPECT_EQ(filter.Lose(7)->relation, Relation::kAbsent);
  EXPECT_FALSE(filter.Lose(8));
  EXPECT_FALSE(filter.Update(9, {0.02}));
  EXPECT_EQ(filter.Update(10, {0.02})->relation, Relation::kNotTouching);
}

}  // namespace
}  // namespace cell
