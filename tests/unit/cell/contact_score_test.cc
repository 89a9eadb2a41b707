#include "services/cell/scoring/contact_score.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

constexpr int64_t kMs = 1000;

class ContactScoreTest : public testing::Test {
 protected:
  static ContactEvent Event(int64_t ms, const std::string& a,
                            const std::string& b, bool is_touch) {
    return {ms * kMs, MakePair(a, b), is_touch};
  }
  ContactScore Score(const std::vector<ContactEvent>& found) const {
    return ScoreContacts(truth_, found, task_.scene_objects, {});
  }

  ShippedTask task_;
  const std::vector<ContactEvent> truth_ = {
      Event(1000, "shaft", "hand_left", true),
      Event(2000, "shaft", "table", false),
      Event(4000, "shaft", "pendulum", true),
      Event(4200, "shaft", "base", true),
      Event(5000, "shaft", "hand_left", false)};
};

TEST_F(ContactScoreTest, TheTruthItselfIsPerfect) {
  const ContactScore score = Score(truth_);
  EXPECT_EQ(score.num_true, 5);
  EXPECT_EQ(score.num_found, 5);
  EXPECT_EQ(score.num_matched, 5);
  EXPECT_EQ(score.num_actions, 1);
  EXPECT_EQ(score.num_exact, 1);
  EXPECT_EQ(score.num_same_columns, 1);
}

TEST_F(ContactScoreTest, AnEventMatchesOnceWithinTheTolerance) {
  auto found = truth_;
  found[1].utime = 2299 * kMs;
  EXPECT_EQ(Score(found).num_matched, 5);
  found[1].utime = 2301 * kMs;
  EXPECT_EQ(Score(found).num_matched, 4);
  found[1] = Event(2000, "shaft", "table", true);
  EXPECT_EQ(Score(found).num_matched, 4);
  found = truth_;
  found.insert(found.begin() + 2, found[1]);
  EXPECT_EQ(Score(found).num_matched, 5);
  EXPECT_EQ(Score(found).num_found, 6);
  EXPECT_EQ(Score(found).num_exact, 0);
}

TEST_F(ContactScoreTest, ChangesNearerThanTheToleranceMayComeInAnyOrder) {
  auto found = truth_;
  std::swap(found[2].pair, found[3].pair);
  EXPECT_EQ(Score(found).num_exact, 1);
  EXPECT_EQ(Score(found).num_same_columns, 0);
  found = truth_;
  std::swap(found[1].pair, found[2].pair);
  std::swap(found[1].is_touch, found[2].is_touch);
  EXPECT_EQ(Score(found).num_exact, 0);
}

TEST_F(ContactScoreTest, ChangesWithinTheMergeTimeAreOneColumn) {
  auto truth = truth_;
  truth[3].utime = 4100 * kMs;
  auto found = truth;
  found[3].utime = found[2].utime;
  EXPECT_EQ(
      ScoreContacts(truth, found, task_.scene_objects, {}).num_same_columns, 1);
  EXPECT_EQ(Score(found).num_same_columns, 0);
}

TEST_F(ContactScoreTest, EventsOfOtherPartsDoNotTouchAnActionsChain) {
  auto found = truth_;
  found.push_back(Event(5100, "head", "table", false));
  EXPECT_EQ(Score(found).num_exact, 1);
  EXPECT_EQ(Score(found).num_matched, 5);
}

// Tracks of a part and a hand above the table, in mm.
class Scripted final : public TrackStream {
 public:
  explicit Scripted(std::vector<double> heights_mm)
      : heights_mm_(std::move(heights_mm)) {}
  std::optional<Tracks> Next() override {
    if (next_ == heights_mm_.size()) return std::nullopt;
    Track part{"shaft", Track::State::kTracked, 1, {}, {}};
    const double z = 1e-3 * heights_mm_[next_];
    part.X_WO = Eigen::Isometry3d(Eigen::Translation3d(0, 0, z));
    return Tracks{96 * kMs * static_cast<int64_t>(next_++), {part}};
  }

 private:
  std::vector<double> heights_mm_;
  size_t next_ = 0;
};

TEST_F(ContactScoreTest, TheTruthIsTheDistanceAtTheTruePoses) {
  const double lowest = -1e3 * PartShape(*task_.parts.Find("shaft"))
                                   .LowestZ(Eigen::Isometry3d::Identity());
  std::vector<double> heights = {0, 3.9, 4.1, 0, 4.1, 9, 9, 9, 3, 3};
  for (double& height : heights) height += lowest;
  Scripted tracks(heights);
  const auto events =
      TrueContactEvents(tracks, task_.scene_objects, task_.parts, 0.004);
  ASSERT_EQ(events.size(), 2u);  // the single frame at 4.1 mm is none
  EXPECT_FALSE(events[0].is_touch);
  EXPECT_EQ(events[0].utime, 4 * 96 * kMs);
  EXPECT_TRUE(events[1].is_touch);
  EXPECT_EQ(events[1].utime, 8 * 96 * kMs);
}

}  // namespace
}  // namespace cell
