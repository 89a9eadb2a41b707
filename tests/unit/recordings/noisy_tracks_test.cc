#include "common/recordings/noisy_tracks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "common/geometry/pose.h"

namespace cell {
namespace {

constexpr int64_t kFrame = 96'000;

// Two parts and a hand that never move.
class Still final : public TrackStream {
 public:
  explicit Still(int num_frames) : num_left_(num_frames) {}
  std::optional<Tracks> Next() override {
    if (num_left_-- == 0) return std::nullopt;
    Track a{"a", Track::State::kTracked, 1, {}, {}};
    a.X_WO = Eigen::Isometry3d(Eigen::Translation3d(1, 0, 0));
    Track b = a;
    b.name = "b";
    b.X_WO.translation().x() = 2;
    Track hand = a;
    hand.name = "hand";
    hand.points = {{1, 0, -0.01}, {1, 0, 0.01}};
    return Tracks{utime_ += kFrame, {a, b, hand}};
  }

 private:
  int num_left_;
  int64_t utime_ = 0;
};

std::vector<Tracks> All(const NoisyTracks::Params& params,
                        int num_frames = 4000) {
  NoisyTracks stream(std::make_unique<Still>(num_frames), params);
  std::vector<Tracks> all;
  while (auto tracks = stream.Next()) all.push_back(*std::move(tracks));
  return all;
}

TEST(NoisyTracks, WithoutNoiseTheTruthComesThrough) {
  const auto all = All({}, 3);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[2].utime, 3 * kFrame);
  ASSERT_EQ(all[2].tracks.size(), 3u);
  EXPECT_EQ(all[2].tracks[1].X_WO.translation().x(), 2);
  EXPECT_TRUE(all[2].tracks[1].X_WO.linear().isIdentity(0));
  EXPECT_EQ(all[2].tracks[2].points[1].z(), 0.01);
}

// Property: variance and correlation are those asked for. The estimates' own
// standard errors are about 3 % here.
TEST(NoisyTracks, ItsNoiseIsStationaryAndCorrelatedAsAsked) {
  NoisyTracks::Params params;
  params.position_sd = 0.002;
  params.rotation_sd = 0.01;
  params.correlation_s = 0.2;
  double sum = 0, square = 0, product = 0, angle_square = 0, last = 0;
  const auto all = All(params, 20'000);
  for (const Tracks& tracks : all) {
    const double x = tracks.Find("b")->X_WO.translation().x() - 2;
    sum += x;
    square += x * x;
    product += x * last;
    last = x;
    const double angle =
        AngleBetween(tracks.Find("b")->X_WO, Eigen::Isometry3d::Identity());
    angle_square += angle * angle;
  }
  const double n = static_cast<double>(all.size());
  EXPECT_NEAR(sum / n, 0, 1e-4);
  EXPECT_NEAR(std::sqrt(square / n), 0.002, 0.0002);
  EXPECT_NEAR(product / square, std::exp(-0.096 / 0.2), 0.05);
  EXPECT_NEAR(std::sqrt(angle_square / n), 0.01 * std::sqrt(3), 0.001);
}

TEST(NoisyTracks, TheFirstFrameIsAsNoisyAsTheOthers) {
  double square = 0;
  constexpr int kSeeds = 2000;
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    NoisyTracks::Params params;
    params.position_sd = 0.002;
    params.seed = seed;
    const double x = All(params, 1)[0].Find("b")->X_WO.translation().x() - 2;
    square += x * x;
  }
  EXPECT_NEAR(std::sqrt(square / kSeeds), 0.002, 0.0002);
}

TEST(NoisyTracks, AHandMovesAsOneBody) {
  NoisyTracks::Params params;
  params.position_sd = 0.005;
  for (const Tracks& tracks : All(params, 50)) {
    const Track& hand = *tracks.Find("hand");
    EXPECT_NEAR((hand.points[1] - hand.points[0]).norm(), 0.02, 1e-12);
    EXPECT_TRUE(((hand.points[1] + hand.points[0]) / 2)
                    .isApprox(hand.X_WO.translation(), 1e-12));
  }
}

TEST(NoisyTracks, DropoutsTakeTheAskedShareOfTheTime) {
  NoisyTracks::Params params;
  params.dropout_probability = 0.02;
  params.dropout_s = 0.5;
  int num_seen = 0;
  const auto all = All(params, 20'000);
  for (const Tracks& tracks : all) num_seen += tracks.Find("a") != nullptr;
  // Of each cycle 0.5 s + half a frame are hidden, 0.096 / 0.02 s are not.
  const double expected = 4.8 / (4.8 + 0.5 + 0.048);
  EXPECT_NEAR(num_seen / static_cast<double>(all.size()), expected, 0.02);
}

TEST(NoisyTracks, OnlyPartsThatLookAlikeAreSwapped) {
  NoisyTracks::Params params;
  params.swap_probability = 0.05;
  EXPECT_EQ(All(params, 100)[99].Find("a")->X_WO.translation().x(), 1);
  params.alike = {{"a", "b"}};
  int num_swapped = 0;
  for (const Tracks& tracks : All(params)) {
    ASSERT_EQ(tracks.tracks.size(), 3u);
    const double a = tracks.Find("a")->X_WO.translation().x();
    EXPECT_EQ(a + tracks.Find("b")->X_WO.translation().x(), 3);
    num_swapped += a == 2;
  }
  EXPECT_GT(num_swapped, 100);
  EXPECT_LT(num_swapped, 2000);
}

TEST(NoisyTracks, TheSameSeedGivesTheSameTracks) {
  NoisyTracks::Params params;
  params.position_sd = 0.002;
  params.dropout_probability = 0.01;
  params.swap_probability = 0.01;
  params.alike = {{"a", "b"}};
  const auto digest = [&] {
    double sum = 0;
    for (const Tracks& tracks : All(params, 300)) {
      for (const Track& track : tracks.tracks) {
        sum = 3 * std::fmod(sum + track.X_WO.translation().sum(), 1.0);
      }
    }
    return sum;
  };
  const double first = digest();
  EXPECT_EQ(digest(), first);
  params.seed = 2;
  EXPECT_NE(digest(), first);
}

TEST(NoisyTracks, RefusesImpossibleNoise) {
  NoisyTracks::Params params;
  params.position_sd = -1;
  EXPECT_THROW(All(params, 1), std::invalid_argument);
  params = {};
  params.dropout_probability = 1.5;
  EXPECT_THROW(All(params, 1), std::invalid_argument);
}

}  // namespace
}  // namespace cell
