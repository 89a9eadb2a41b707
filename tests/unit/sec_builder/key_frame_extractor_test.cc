#include "services/sec_builder/key_frame_extractor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace cell {

using namespace sec_builder;
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr int64_t kFrame = 96'000;

// A scene of a, b, c (by name parts "a", "b"), a hand and the table.
class KeyFrameExtractorTest : public testing::Test {
 protected:
  static PartTable Parts() {
    return PartTable::FromConfig(Config::Parse(R"(
contacts: []
parts:
  a: &part
    type: t
    symmetry_order: 1
    density: 1000
    colour: [1, 1, 1]
    pieces: [{kind: box, center: [0, 0, 0], size: [20, 20, 20]}]
  b: *part
)",
                                               "parts.yaml"));
  }

  explicit KeyFrameExtractorTest(
      const std::vector<std::string>& hands = {"hand"})
      : scene_objects_(Parts(), hands) {
    for (const std::string& name : scene_objects_.names()) {
      if (name == SceneObjects::kTable) continue;
      tracks_.tracks.push_back(
          {name, Track::State::kTracked, 1, Eigen::Isometry3d::Identity(), {}});
    }
  }

  Proximities Measured() const {
    Proximities proximities;
    const auto is_seen = [&](const std::string& name) {
      const Track* track = tracks_.Find(name);
      return name == SceneObjects::kTable ||
             (track && track->state == Track::State::kTracked);
    };
    for (const std::string& a : scene_objects_.names()) {
      for (const std::string& b : scene_objects_.names()) {
        if (a >= b || !is_seen(a) || !is_seen(b)) continue;
        const bool touch = touching_.contains({a, b});
        proximities[{a, b}] = {touch ? 0 : 0.015};
      }
    }
    return proximities;
  }

  std::vector<KeyFrame> Next() {
    auto frames = extractor_.Update(tracks_, Measured());
    tracks_.utime += kFrame;
    return frames;
  }
  std::vector<KeyFrame> Next(int count) {
    std::vector<KeyFrame> all;
    for (int i = 0; i < count; ++i) {
      for (KeyFrame& frame : Next()) all.push_back(frame);
    }
    return all;
  }
  void SetState(const std::string& name, Track::State state) {
    for (Track& track : tracks_.tracks) {
      if (track.name == name) track.state = state;
    }
  }

  const SceneObjects scene_objects_;
  std::set<ObjectPair> touching_ = {{"a", "table"}, {"b", "table"}};
  Tracks tracks_;
  KeyFrameExtractor extractor_{scene_objects_, {}};
};

TEST_F(KeyFrameExtractorTest, KeyFrameZeroIsTheInitialTopology) {
  EXPECT_THAT(Next(), IsEmpty());
  const auto frames = Next();
  ASSERT_THAT(frames, SizeIs(1));
  EXPECT_EQ(frames[0].index, 0);
  EXPECT_EQ(frames[0].utime, 0);
  EXPECT_THAT(frames[0].relations, SizeIs(6));
  EXPECT_TRUE(Touch(frames[0].relations, "a", "table"));
  EXPECT_FALSE(Touch(frames[0].relations, "a", "hand"));
  EXPECT_THAT(frames[0].poses, SizeIs(2));
  EXPECT_THAT(Next(100), IsEmpty());
}

TEST_F(KeyFrameExtractorTest, AChangeIsAKeyFrameDatedBackWithThePosesOfItsEnd) {
  Next(10);
  touching_.insert({"a", "hand"});
  EXPECT_THAT(Next(2), IsEmpty());
  tracks_.tracks[0].X_WO.translation().x() = 0.5;
  const auto frames = Next();
  ASSERT_THAT(frames, SizeIs(1));
  EXPECT_EQ(frames[0].index, 1);
  EXPECT_EQ(frames[0].utime, 10 * kFrame);
  EXPECT_TRUE(Touch(frames[0].relations, "hand", "a"));
  EXPECT_EQ(frames[0].poses.at("a").translation().x(), 0.5);
}

TEST_F(KeyFrameExtractorTest, ChangesThatBeginTogetherAreOneKeyFrame) {
  Next(10);
  touching_.insert({"a", "hand"});
  Next();
  touching_.insert({"a", "b"});  // 96 ms later
  const auto frames = Next(10);
  ASSERT_THAT(frames, SizeIs(1));
  EXPECT_TRUE(Touch(frames[0].relations, "a", "hand"));
  EXPECT_TRUE(Touch(frames[0].relations, "a", "b"));
}

TEST_F(KeyFrameExtractorTest, ChangesThatBeginApartAreKeyFramesInTheirOrder) {
  Next(10);
  touching_.insert({"a", "hand"});
  Next(2);
  touching_.insert({"a", "b"});  // 192 ms later
  const auto frames = Next(10);
  ASSERT_THAT(frames, SizeIs(2));
  EXPECT_FALSE(Touch(frames[0].relations, "a", "b"));
  EXPECT_TRUE(Touch(frames[1].relations, "a", "b"));
  EXPECT_EQ(frames[0].utime, 10 * kFrame);
  EXPECT_EQ(frames[1].utime, 12 * kFrame);
  EXPECT_EQ(frames[1].index, frames[0].index + 1);
}

TEST_F(KeyFrameExtractorTest, HasTheRelativePoseOfEachTouchingPair) {
  touching_ = {{"a", "table"}, {"a", "b"}};
  tracks_.tracks[0].X_WO.translation() << 0.1, 0.2, 0.3;
  tracks_.tracks[0].X_WO.linear() =
      Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  tracks_.tracks[1].X_WO.translation() << 0.1, 0.5, 0.3;
  const auto frames = Next(3);
  ASSERT_THAT(frames, SizeIs(1));
  const auto& poses = frames[0].relative_poses;
  ASSERT_THAT(poses, SizeIs(2));
  // b is 0.3 m along y of W, which is x of a.
  EXPECT_TRUE(poses.at({"a", "b"})
                  .translation()
                  .isApprox(Eigen::Vector3d(0.3, 0, 0), 1e-12));
  EXPECT_TRUE(poses.at({"a", "table"})
                  .isApprox(tracks_.tracks[0].X_WO.inverse(), 1e-12));
}

TEST_F(KeyFrameExtractorTest, TheSegmentBeginsAtThePreviousKeyFrame) {
  const auto first = Next(10);
  touching_.insert({"a", "hand"});
  const auto frames = Next(10);
  ASSERT_THAT(frames, SizeIs(1));
  EXPECT_EQ(frames[0].segment.begin_utime, first[0].utime);
  EXPECT_EQ(frames[0].segment.channels, std::vector<std::string>{"TRACKS"});
}

class ExtractorBesideAnArm : public KeyFrameExtractorTest {
 protected:
  ExtractorBesideAnArm() : KeyFrameExtractorTest({"gripper", "hand"}) {}
};

TEST_F(ExtractorBesideAnArm, WhereItActedTheSegmentNamesItsChannels) {
  KeyFrameExtractor::Params params;
  params.channels["gripper"] = {"WRENCH", "ARM_STATE"};
  extractor_ = KeyFrameExtractor(scene_objects_, params);
  const auto first = Next(10);
  EXPECT_EQ(first[0].segment.channels, std::vector<std::string>{"TRACKS"});
  touching_.insert({"a", "gripper"});
  const std::vector<std::string> all = {"ARM_STATE", "TRACKS", "WRENCH"};
  EXPECT_EQ(Next(10)[0].segment.channels, all);
  touching_.erase({"a", "gripper"});
  EXPECT_EQ(Next(10)[0].segment.channels, all);
  touching_.insert({"a", "hand"});
  EXPECT_EQ(Next(10)[0].segment.channels, first[0].segment.channels);
}

TEST_F(ExtractorBesideAnArm, AHandThatPassesTheGripperIsNoEvent) {
  Next(10);
  touching_.insert({"gripper", "hand"});
  EXPECT_THAT(Next(10), IsEmpty());
  touching_.clear();
  EXPECT_THAT(Next(10), SizeIs(1));  // a and b were lifted
}

TEST_F(ExtractorBesideAnArm, AHandThatPassesTheGripperDoesNotMoveAPlacement) {
  touching_.insert({"a", "hand"});
  Next(10);
  touching_.insert({"gripper", "hand"});
  Next();
  touching_.erase({"a", "hand"});
  const auto frames = Next(10);
  ASSERT_THAT(frames, SizeIs(1));
  EXPECT_EQ(frames[0].utime, 11 * kFrame);
  EXPECT_FALSE(Touch(frames[0].relations, "a", "hand"));
  EXPECT_TRUE(Touch(frames[0].relations, "gripper", "hand"));
}

TEST_F(KeyFrameExtractorTest, AShortTouchIsNoKeyFrame) {
  Next(10);
  touching_.insert({"a", "hand"});
  Next();
  touching_.erase({"a", "hand"});
  EXPECT_THAT(Next(20), IsEmpty());
}

TEST_F(KeyFrameExtractorTest, ChangesThatCancelOutWithinOneKeyFrameAreNone) {
  KeyFrameExtractor::Params params;
  params.pair.confirm_frames = 1;
  extractor_ = KeyFrameExtractor(scene_objects_, params);
  Next(10);
  touching_.insert({"a", "hand"});
  Next();
  touching_.erase({"a", "hand"});
  EXPECT_THAT(Next(20), IsEmpty());
}

// The tracker takes one for the other: in place of b, a is in the hand.
TEST_F(KeyFrameExtractorTest,
       PartsThatLookAlikeMayChangeNamesWithoutAKeyFrame) {
  for (const bool are_alike : {true, false}) {
    KeyFrameExtractor::Params params;
    if (are_alike) params.alike = {{"a", "t"}, {"b", "t"}};
    extractor_ = KeyFrameExtractor(scene_objects_, params);
    touching_ = {{"a", "table"}, {"b", "hand"}};
    EXPECT_THAT(Next(10), SizeIs(1));
    touching_ = {{"a", "hand"}, {"b", "table"}};
    EXPECT_THAT(Next(20), SizeIs(are_alike ? 0 : 1));
    touching_ = {{"a", "table"}, {"b", "table"}};
    const auto frames = Next(20);
    ASSERT_THAT(frames, SizeIs(1)) << "it is put down";
    EXPECT_EQ(frames[0].index, are_alike ? 1 : 2);
    EXPECT_FALSE(Touch(frames[0].relations, "a", "hand"));
  }
}

TEST_F(KeyFrameExtractorTest, WithoutATrackForASecondAnObjectIsAbsent) {
  Next(10);
  SetState("b", Track::State::kLost);
  EXPECT_THAT(Next(10), IsEmpty());
  const auto frames = Next(4);
  ASSERT_THAT(frames, SizeIs(1));
  for (const auto& [pair, relation] : frames[0].relations) {
    const bool is_of_b = pair.first == "b" || pair.second == "b";
    EXPECT_EQ(relation == Relation::kAbsent, is_of_b);
  }
  EXPECT_FALSE(frames[0].poses.contains("b"));
  SetState("b", Track::State::kTracked);
  const auto back = Next(5);
  ASSERT_THAT(back, SizeIs(1));
  EXPECT_TRUE(Touch(back[0].relations, "b", "table"));
}

TEST_F(KeyFrameExtractorTest, WhileFrozenTheLastRelationHolds) {
  touching_.insert({"a", "b"});
  Next(10);
  SetState("b", Track::State::kFrozen);
  touching_.erase({"a", "b"});
  EXPECT_THAT(Next(100), IsEmpty());
  SetState("b", Track::State::kTracked);
  const auto frames = Next(5);
  ASSERT_THAT(frames, SizeIs(1));
  EXPECT_FALSE(Touch(frames[0].relations, "a", "b"));
}

// Property: only differences of stamps matter.
TEST_F(KeyFrameExtractorTest, IsInvariantToATimeShift) {
  std::vector<std::vector<KeyFrame>> runs;
  for (const int64_t shift : {int64_t{0}, int64_t{1'700'000'000'000'000}}) {
    extractor_ = KeyFrameExtractor(scene_objects_, {});
    tracks_.utime = shift;
    touching_ = {};
    std::vector<KeyFrame>& run = runs.emplace_back();
    for (int i = 0; i < 200; ++i) {
      if (i % 7 == 3) touching_.insert({"a", "hand"});
      if (i % 11 == 5) touching_.insert({"a", "b"});
      if (i % 13 == 0) touching_.clear();
      for (KeyFrame& frame : Next()) {
        frame.utime -= shift;
        run.push_back(frame);
      }
    }
  }
  EXPECT_GT(runs[0].size(), 20u);
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (size_t i = 0; i < runs[0].size(); ++i) {
    EXPECT_EQ(runs[0][i].utime, runs[1][i].utime);
    EXPECT_EQ(runs[0][i].relations, runs[1][i].relations);
    EXPECT_EQ(runs[0][i].index, static_cast<int64_t>(i));
  }
}

}  // namespace
}  // namespace cell
