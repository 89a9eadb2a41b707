// What the tracker sees and the task has no model of: segments take part in
// relations as far as their extent is known.
#include <gmock/gmock.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cell/alert_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/tracks_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/stepper.h"
#include "common/sec/event_chain.h"
#include "services/sec_builder/sec_builder.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace sec_builder;

namespace {

using Eigen::Vector3d;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int32_t kFrameTicks = 12;

/// A cube of 40 mm, its surface every 10 mm. @param bottom  its lowest point
Track Cube(const std::string& name, const Vector3d& bottom) {
  constexpr int kSteps = 4;
  constexpr double kStep = 0.01;
  Track track{name};
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      for (int k = 0; k <= kSteps; ++k) {
        const bool is_inside =
            i % kSteps != 0 && j % kSteps != 0 && k % kSteps != 0;
        if (is_inside) continue;
        track.points.push_back(
            bottom + kStep * Vector3d(i - kSteps / 2, j - kSteps / 2, k));
      }
    }
  }
  track.X_WO = Eigen::Translation3d(bottom + Vector3d(0, 0, 0.02));
  return track;
}

/// sec_builder alone, which sees the parts at rest and something else.
class Segments : public testing::Test {
 protected:
  Segments() {
    Stepper::Params params;
    params.name = "sec_builder";
    params.sender = 1;
    stepper_ = std::make_unique<Stepper>(params);
    service_ = MakeSecBuilder(*stepper_, ShippedDeployment());
  }

  /// Sees the parts and `others` for so many frames.
  void See(const std::vector<Track>& others, int num_frames = 10) {
    for (int i = 0; i < num_frames; ++i) {
      Tracks tracks = stage_.AllTracked();
      tracks.segments = others;
      tracks.utime = tick_ * kTickUs;
      Send(TracksToMessage(tracks, task_.scene_objects));
    }
  }
  void Send(tracks_t message) {
    message.header.tick = tick_;
    const Message wire = *MessageFromWire("TRACKS", Bus::Encode(message));
    EXPECT_EQ(stepper_->Accept(tick_, {wire}), Stepper::State::kReady);
    for (const Message& sent : stepper_->Run()) Read(sent);
    tick_ += kFrameTicks;
  }
  void Read(const Message& sent) {
    if (sent.channel == "KEY_FRAME") {
      auto frame =
          KeyFrameFromMessage(*Decode<key_frame_t>(sent), task_.scene_objects);
      ASSERT_TRUE(frame);
      frames_.push_back(*std::move(frame));
    }
    if (sent.channel == "ALERT") alerts_.push_back(*Decode<alert_t>(sent));
  }
  /// On the table, between rows of parts.
  static Vector3d Aside() { return {0.0, -0.20, 0.0}; }
  /// Its side is at the side of the shaft.
  Vector3d AtTheShaft() const {
    const PartShape shape(*task_.parts.Find("shaft"));
    const Vector3d p_W = stage_.PoseOf("shaft").translation();
    return {p_W.x(), p_W.y() - shape.box().sizes().y() / 2 - 0.021, 0};
  }

  const ShippedTask task_;
  const Stage stage_{task_};
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<Service> service_;
  int32_t tick_ = 0;
  std::vector<KeyFrame> frames_;
  std::vector<alert_t> alerts_;
};

TEST_F(Segments, AreInKeyFramesWithAllPairs) {
  See({Cube("segment 7", Aside())});
  ASSERT_THAT(frames_, SizeIs(1));
  const auto& names = task_.scene_objects.names();
  EXPECT_EQ(frames_[0].segment_relations.size(), names.size());
  EXPECT_TRUE(Touch(frames_[0].segment_relations, "segment 7", "table"));
  EXPECT_EQ(frames_[0].relations.size(), names.size() * (names.size() - 1) / 2);
  EXPECT_TRUE(frames_[0].relative_poses.contains({"segment 7", "table"}));
}

TEST_F(Segments, ThatTouchAndLeaveAPartAreARowOfTheChain) {
  See({Cube("segment 7", Aside())});
  See({Cube("segment 7", AtTheShaft())});
  See({Cube("segment 7", Aside())});
  EXPECT_THAT(alerts_, IsEmpty());
  ASSERT_THAT(frames_, SizeIs(3));
  const EventChain chain = ChainOf(frames_).RowsOf("segment 7");
  const auto row = chain.FindRow({"segment 7", "shaft"});
  ASSERT_TRUE(row);
  EXPECT_EQ(chain.Row(*row),
            (std::vector{Relation::kNotTouching, Relation::kTouching,
                         Relation::kNotTouching}));
  EXPECT_EQ(chain.ChangingRows().num_rows(), 1u);
}

TEST_F(Segments, ComeAndGoWithoutAKeyFrameAndAreAbsentFromTheNext) {
  See({});
  See({Cube("segment 7", AtTheShaft())});
  ASSERT_THAT(frames_, SizeIs(1));
  See({Cube("segment 7", Aside())});
  See({}, 20);
  ASSERT_THAT(frames_, SizeIs(2)) << "only that it left the shaft";
  See({Cube("segment 8", Aside())});
  See({Cube("segment 8", AtTheShaft())});
  ASSERT_THAT(frames_, SizeIs(3));
  const EventChain chain = ChainOf(frames_);
  const auto row = [&](const std::string& name) {
    return chain.Row(*chain.FindRow({name, "shaft"}));
  };
  using enum Relation;
  EXPECT_EQ(row("segment 7"), (std::vector{kAbsent, kNotTouching, kAbsent}));
  EXPECT_EQ(row("segment 8"), (std::vector{kAbsent, kAbsent, kTouching}));
}

TEST_F(Segments, OfAnotherNameOrKindAreSegmentsAllTheSame) {
  Tracks tracks = stage_.AllTracked();
  tracks.segments = {Cube("segment cup", Aside())};
  tracks_t message = TracksToMessage(tracks, task_.scene_objects);
  for (track_t& track : message.tracks) {
    if (track.name != "segment cup") continue;
    EXPECT_EQ(track.kind, track_t::SEGMENT);
    track.name = "zz_cup";
    track.kind = track_t::PART;
  }
  std::ranges::sort(message.tracks, {}, &track_t::name);
  const auto back = TracksFromMessage(message, task_.scene_objects);
  ASSERT_TRUE(back);
  ASSERT_THAT(back->segments, SizeIs(1));
  EXPECT_NE(back->Find("segment zz_cup"), nullptr);
  EXPECT_EQ(back->tracks.size(), stage_.AllTracked().tracks.size());
}

TEST_F(Segments, WithoutPointsAreNamedOnceAndTheRestGoesOn) {
  for (int i = 0; i < 10; ++i) {
    Tracks tracks = stage_.AllTracked();
    tracks.utime = tick_ * kTickUs;
    tracks_t message = TracksToMessage(tracks, task_.scene_objects);
    message.tracks.push_back({message.tracks.back()});
    message.tracks.back().name = "zz_cup";
    message.num_tracks += 1;
    Send(message);
  }
  EXPECT_THAT(frames_, SizeIs(1));
  EXPECT_THAT(frames_.at(0).segment_relations, IsEmpty());
  ASSERT_THAT(alerts_, SizeIs(1));
  EXPECT_THAT(alerts_[0].text,
              AllOf(HasSubstr("'zz_cup'"), HasSubstr("no surface points"),
                    HasSubstr("no part in relations")));
}

TEST_F(Segments, OfForbiddenNamesTwiceOrTooManyAreRefused) {
  const auto comes_back = [&](const std::vector<std::string>& names) {
    Tracks tracks;
    tracks_t message{};
    for (const std::string& name : names) {
      tracks.segments = {Cube("segment 1", Aside())};
      track_t track = TracksToMessage(tracks, task_.scene_objects).tracks[0];
      track.name = name;
      message.tracks.push_back(track);
    }
    message.num_tracks = static_cast<int32_t>(names.size());
    return TracksFromMessage(message, task_.scene_objects).has_value();
  };
  EXPECT_TRUE(comes_back({"1", "segment 2"}));
  EXPECT_FALSE(comes_back({"1", "segment 1"}));
  EXPECT_FALSE(comes_back({""}));
  EXPECT_FALSE(comes_back({"two words"}));
  EXPECT_FALSE(comes_back({"table"}));
  EXPECT_FALSE(comes_back({std::string(100, 'x')}));
  std::vector<std::string> many;
  for (int i = 0; i < 100; ++i) many.push_back(std::to_string(1000 + i));
  EXPECT_FALSE(comes_back(many));
}

TEST_F(Segments, AForgedKeyFrameOfThemIsRefused) {
  See({Cube("segment 7", Aside())});
  ASSERT_THAT(frames_, SizeIs(1));
  const key_frame_t good = KeyFrameToMessage(frames_[0]);
  EXPECT_TRUE(KeyFrameFromMessage(good, task_.scene_objects));
  const auto place =
      std::ranges::find_if(good.relations, [](const relation_t& r) {
        return r.first == "segment 7" || r.second == "segment 7";
      });
  const auto at = static_cast<size_t>(place - good.relations.begin());
  key_frame_t one_less = good;
  one_less.relations.erase(one_less.relations.begin() +
                           static_cast<std::ptrdiff_t>(at));
  EXPECT_FALSE(KeyFrameFromMessage(one_less, task_.scene_objects));
  key_frame_t renamed = good;
  renamed.relations[at].second = "segment 9";
  EXPECT_FALSE(KeyFrameFromMessage(renamed, task_.scene_objects));
  key_frame_t unknown = good;
  unknown.relations[at].relation = 4;
  EXPECT_FALSE(KeyFrameFromMessage(unknown, task_.scene_objects));
}

}  // namespace
}  // namespace cell
