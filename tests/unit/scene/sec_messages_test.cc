#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "common/geometry/pose.h"
#include "common/scene/key_frame.h"
#include "common/scene/track.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class SecMessagesTest : public testing::Test {
 protected:
  ShippedTask task_;
  Stage stage_{task_};
};

TEST_F(SecMessagesTest, AKeyFrameComesBackAsItWentIn) {
  stage_.Seat("shaft", "base.shaft");
  stage_.Hold("hand_left", "head");
  stage_.Remove("separator");
  stage_.Frame();
  KeyFrame frame = stage_.Frame();
  frame.relative_poses[{"base", "shaft"}] =
      stage_.PoseOf("base").inverse() * stage_.PoseOf("shaft");
  frame.relative_poses[{"hand_left", "head"}] =
      Eigen::Isometry3d(Eigen::Translation3d(0, 0.5, 0));
  frame.segment = {100'000, {"ARM_STATE_LEFT", "TRACKS"}};
  const auto back =
      KeyFrameFromMessage(KeyFrameToMessage(frame), task_.scene_objects);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->utime, frame.utime);
  EXPECT_EQ(back->index, frame.index);
  EXPECT_EQ(back->relations, frame.relations);
  ASSERT_EQ(back->poses.size(), frame.poses.size());
  for (const auto& [name, X_WO] : frame.poses) {
    EXPECT_TRUE(back->poses.at(name).isApprox(X_WO, 1e-12)) << name;
  }
  ASSERT_EQ(back->relative_poses.size(), 2u);
  for (const auto& [pair, X_AB] : frame.relative_poses) {
    EXPECT_TRUE(back->relative_poses.at(pair).isApprox(X_AB, 1e-12));
  }
  EXPECT_EQ(back->segment.begin_utime, 100'000);
  EXPECT_EQ(back->segment.channels, frame.segment.channels);
}

TEST_F(SecMessagesTest, AForgedKeyFrameIsRefused) {
  stage_.Seat("shaft", "base.shaft");
  stage_.Hold("hand_left", "head");
  KeyFrame frame = stage_.Frame();
  frame.relative_poses[{"base", "shaft"}] = Eigen::Isometry3d::Identity();
  frame.relative_poses[{"hand_left", "head"}] = Eigen::Isometry3d::Identity();
  frame.segment.channels = {"ARM_STATE_LEFT", "TRACKS"};
  const key_frame_t good = KeyFrameToMessage(frame);
  ASSERT_TRUE(KeyFrameFromMessage(good, task_.scene_objects));
  const std::vector<std::function<void(key_frame_t&)>> forgeries = {
      [](key_frame_t& m) { m.index = -1; },
      [](key_frame_t& m) { m.relations[3].relation = 3; },
      [](key_frame_t& m) { m.relations[3].first = "nobody"; },
      [](key_frame_t& m) { std::swap(m.relations[3], m.relations[4]); },
      [](key_frame_t& m) { m.relations.pop_back(); },
      [](key_frame_t& m) { m.relations.push_back(m.relations.back()); },
      [](key_frame_t& m) { m.poses[2].name = "nobody"; },
      [](key_frame_t& m) { m.poses[2].name = "table"; },
      [](key_frame_t& m) { m.poses[2].name = "hand_left"; },
      [](key_frame_t& m) { m.poses[2].name = m.poses[1].name; },
      [](key_frame_t& m) { std::swap(m.poses[2], m.poses[3]); },
      [](key_frame_t& m) { m.poses[2].pose_world_body.position[0] = kNan; },
      [](key_frame_t& m) { m.poses[2].pose_world_body.quat_wxyz[0] = 2; },
      [](key_frame_t& m) { m.relative_poses[1].first = "nobody"; },
      [](key_frame_t& m) { m.relative_poses[1].second = "pendulum"; },
      [](key_frame_t& m) {
        std::swap(m.relative_poses[1].first, m.relative_poses[1].second);
      },
      [](key_frame_t& m) { m.relative_poses[1] = m.relative_poses[0]; },
      [](key_frame_t& m) { m.relative_poses[0].position[2] = kNan; },
      [](key_frame_t& m) { m.relative_poses[0].quat_wxyz[0] = 2; },
      [](key_frame_t& m) { m.segment.begin_utime = m.header.utime + 1; },
      [](key_frame_t& m) { m.segment.begin_utime = -1; },
      [](key_frame_t& m) { m.segment.end_utime += 1; },
      [](key_frame_t& m) { m.segment.channels[1] = "ARM_STATE_LEFT"; },
      [](key_frame_t& m) { m.segment.channels[0].clear(); },
      [](key_frame_t& m) {
        m.segment.channels[0] = std::string(100, 'A');
      }};
  for (size_t i = 0; i < forgeries.size(); ++i) {
    key_frame_t message = good;
    forgeries[i](message);
    EXPECT_FALSE(KeyFrameFromMessage(message, task_.scene_objects)) << i;
  }
}

Tracks TracksWithHand(const Stage& stage) {
  Tracks tracks = stage.AllTracked();
  Track hand{"hand_left", Track::State::kTracked, 0.5, {}, {}};
  hand.X_WO = Eigen::Isometry3d::Identity();
  hand.points = {{0.125, 0.25, 0.5}, {1, 2, 3}};
  tracks.tracks.push_back(hand);
  std::sort(tracks.tracks.begin(), tracks.tracks.end(),
            [](const Track& a, const Track& b) { return a.name < b.name; });
  return tracks;
}

TEST_F(SecMessagesTest, TracksComeBackAsTheyWentIn) {
  Tracks tracks = TracksWithHand(stage_);
  tracks.utime = 96'000;
  tracks.tracks[1].state = Track::State::kFrozen;
  const auto back = TracksFromMessage(
      TracksToMessage(tracks, task_.scene_objects), task_.scene_objects);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->utime, 96'000);
  ASSERT_EQ(back->tracks.size(), tracks.tracks.size());
  for (const Track& track : tracks.tracks) {
    const Track* found = back->Find(track.name);
    ASSERT_NE(found, nullptr) << track.name;
    EXPECT_EQ(found->state, track.state);
    EXPECT_EQ(found->confidence, track.confidence);
    EXPECT_EQ(found->points, track.points);
    EXPECT_TRUE(found->X_WO.isApprox(track.X_WO, 1e-12));
  }
  EXPECT_EQ(back->Find("nobody"), nullptr);
}

TEST_F(SecMessagesTest, ForgedTracksAreRefused) {
  const tracks_t good =
      TracksToMessage(TracksWithHand(stage_), task_.scene_objects);
  ASSERT_TRUE(TracksFromMessage(good, task_.scene_objects));
  size_t hand = 0;
  while (good.tracks[hand].name != "hand_left") ++hand;
  const std::vector<std::function<void(tracks_t&)>> forgeries = {
      [](tracks_t& m) { m.tracks[0].name = "nobody"; },
      [](tracks_t& m) { m.tracks[0].name = "table"; },
      [](tracks_t& m) { std::swap(m.tracks[0], m.tracks[1]); },
      [](tracks_t& m) { m.tracks.push_back(m.tracks.back()); },
      [](tracks_t& m) { m.tracks[0].kind = track_t::HAND; },
      [](tracks_t& m) { m.tracks[0].kind = 2; },
      [](tracks_t& m) { m.tracks[0].state = 3; },
      [](tracks_t& m) { m.tracks[0].state = -1; },
      [](tracks_t& m) { m.tracks[0].confidence = kNan; },
      [](tracks_t& m) { m.tracks[0].confidence = 1.1; },
      [](tracks_t& m) { m.tracks[0].pose_world_object.position[2] = kNan; },
      [](tracks_t& m) { m.tracks[0].points.resize(1); },
      [&](tracks_t& m) { m.tracks[hand].kind = track_t::PART; },
      [&](tracks_t& m) { m.tracks[hand].points[1].xyz[2] = 1e9F; },
      [&](tracks_t& m) {
        m.tracks[hand].points[1].xyz[2] = static_cast<float>(kNan);
      },
      [&](tracks_t& m) {
        m.tracks[hand].points.resize(100'000);
      }};
  for (size_t i = 0; i < forgeries.size(); ++i) {
    tracks_t message = good;
    forgeries[i](message);
    EXPECT_FALSE(TracksFromMessage(message, task_.scene_objects)) << i;
  }
}

TEST(SceneObjects, RefusesDuplicateNames) {
  EXPECT_THROW(SceneObjects(PartTable(), {"table"}), std::invalid_argument);
  EXPECT_THROW(SceneObjects(PartTable(), {"a", "a"}), std::invalid_argument);
}

}  // namespace
}  // namespace cell
