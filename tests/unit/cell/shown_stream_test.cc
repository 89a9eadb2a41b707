#include "services/cell/evaluations/shown_stream.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "common/recordings/recording_file.h"
#include "services/cell/evaluations/stream_score.h"
#include "services/cell/recordings/joined_tracks.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using recognizer::RecognisedAction;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Kind = Recording::TrueAction::Kind;

class AtTimes final : public TrackStream {
 public:
  explicit AtTimes(std::vector<int64_t> utimes) : utimes_(std::move(utimes)) {}
  std::optional<Tracks> Next() override {
    if (next_ == utimes_.size()) return std::nullopt;
    return Tracks{utimes_[next_++], {Track{.name = "a"}}};
  }

 private:
  std::vector<int64_t> utimes_;
  size_t next_ = 0;
};

TEST(JoinedTracks, BetweenTwoDemonstrationsNothingHasATrack) {
  const std::vector<std::vector<int64_t>> streams = {{100, 200}, {}, {50, 150}};
  size_t next = 0;
  JoinedTracks joined(
      [&]() -> std::unique_ptr<TrackStream> {
        if (next == streams.size()) return nullptr;
        return std::make_unique<AtTimes>(streams[next++]);
      },
      {.gap_us = 300, .period_us = 100});
  std::vector<std::pair<int64_t, size_t>> seen;  // utime, number of tracks
  while (const auto tracks = joined.Next()) {
    seen.emplace_back(tracks->utime, tracks->tracks.size());
  }
  using Seen = std::pair<int64_t, size_t>;
  EXPECT_THAT(seen, ElementsAre(Seen(100, 1), Seen(200, 1), Seen(300, 0),
                                Seen(400, 0), Seen(500, 1), Seen(600, 1)));
  EXPECT_THAT(joined.offsets(), ElementsAre(0, 0, 450));
}

// The shipped recordings have no truth of what was done.
TEST(ShowStream, RecognisesARecordingTwiceInOneStreamFromNoisyPoses) {
  const ShippedTask task;
  ShownStreamParams params;
  for (const char* name : {"first", "again"}) {
    params.demonstrations.push_back({name, [] {
                                       return LoadRecording(
                                           ShippedDeployment().task_dir /
                                           "recordings/assembly-1.recording");
                                     }});
  }
  params.noise_mm = 2;
  params.library = task.MakeLibrary();
  const ShownStream stream =
      ShowStream(params, ShippedDeployment(), task, [](const auto&) {});
  EXPECT_THAT(stream.done, IsEmpty());
  ASSERT_THAT(stream.recognised, SizeIs(18));
  for (size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(stream.recognised[i].name, stream.recognised[i + 9].name);
    EXPECT_EQ(stream.recognised[i].direction, ActionDirection::kForward) << i;
  }
}

ShownStream::Done Did(double s, Kind kind, const std::string& part,
                      const std::string& site = "") {
  return {"shown", 0, {static_cast<int64_t>(s * 1e6), kind, part, site}};
}

RecognisedAction Saw(double s, ActionDirection direction,
                     const std::string& part, const std::string& name = "",
                     const std::vector<std::string>& arguments = {}) {
  RecognisedAction action;
  action.direction = direction;
  action.name = name;
  action.arguments = arguments;
  action.part = part;
  action.place_utime = static_cast<int64_t>(s * 1e6);
  return action;
}

const std::map<std::string, std::string> kNames = {{"bolt", "Insert"},
                                                   {"lid", "Close"}};

TEST(StreamScore, CountsWhatIsNamedAsItWasDone) {
  using enum ActionDirection;
  const ShownStream stream{
      {Did(10, Kind::kPlaced, "bolt", "plate.a"),
       Did(20, Kind::kTakenBack, "bolt", "plate.a"),
       Did(30, Kind::kMoved, "lid"),
       Did(40, Kind::kPlaced, "lid", "plate.top")},
      {Saw(10.2, kForward, "bolt", "Insert", {"bolt", "plate.a"}),
       Saw(20.2, kReversed, "bolt", "Insert", {"bolt", "plate.a"}),
       Saw(29.9, kUnknown, "lid"), Saw(40, kForward, "lid", "Close", {"lid"})}};
  const StreamScore score = Score(stream, kNames);
  EXPECT_EQ(score.num_actions, 3);
  EXPECT_EQ(score.num_actions_right, 3);
  EXPECT_EQ(score.num_named, 3);
  EXPECT_EQ(score.num_named_right, 3);
  EXPECT_EQ(score.num_reversals_right, 1);
  EXPECT_EQ(score.num_moves_right, 1);
  EXPECT_EQ(score.num_unknown_right, 1);
  EXPECT_THAT(score.errors, IsEmpty());
}

TEST(StreamScore, WrongNamesPlacesTimesAndFalseActionsAreErrors) {
  using enum ActionDirection;
  const ShownStream stream{
      {Did(10, Kind::kPlaced, "bolt", "plate.a"),
       Did(20, Kind::kPlaced, "lid", "plate.top"),
       Did(30, Kind::kMoved, "lid")},
      {Saw(10, kForward, "bolt", "Insert", {"bolt", "plate.b"}),
       Saw(22, kForward, "lid", "Close", {"lid"}),
       Saw(30, kReversed, "lid", "Close", {"lid"})}};
  const StreamScore score = Score(stream, kNames);
  EXPECT_EQ(score.num_actions_right, 0);
  EXPECT_EQ(score.num_named, 3);
  EXPECT_EQ(score.num_named_right, 0);
  EXPECT_EQ(score.num_moves_right, 0);
  EXPECT_THAT(
      score.errors,
      ElementsAre(HasSubstr("10.00 s: bolt placed at plate.a is recognised as "
                            "Insert(bolt, plate.b)"),
                  HasSubstr("20.00 s: lid placed at plate.top is not"),
                  HasSubstr("30.00 s: lid moved is recognised as undone Close"),
                  HasSubstr("22.00 s: lid: Close(lid) is recognised, but")));
}

}  // namespace
}  // namespace cell
