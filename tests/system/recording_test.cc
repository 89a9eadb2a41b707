// A recording of a run can replace the run: both give the same results.
#include "common/recordings/recording.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cell/key_frame_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/decode.h"
#include "common/bus/run_log.h"
#include "common/recordings/recording_text.h"
#include "services/cell/recordings/recorded_tracks.h"
#include "services/cell/recordings/run_recording.h"
#include "services/sec_builder/key_frame_builder.h"
#include "tests/system/run_cell.h"

namespace cell {

using namespace cli;
using namespace sec_builder;
namespace {

using testing::HasSubstr;

class RecordingOfARun : public RunCell {
 protected:
  std::vector<key_frame_t> KeyFramesOfTheLog() const {
    std::vector<key_frame_t> frames;
    const RunLog log = RunLog::Load(dir_ / "run");
    for (const auto& [tick, entry] : log.ticks()) {
      for (const Message& message : entry.messages) {
        if (message.channel != "KEY_FRAME") continue;
        frames.push_back(Decode<key_frame_t>(message).value());
        frames.back().header = {frames.back().header.utime};
      }
    }
    return frames;
  }

  static std::vector<key_frame_t> KeyFramesOf(const Recording& recording,
                                              const Deployment& deployment) {
    const Task task = LoadTask(deployment);
    KeyFrameBuilder builder(KeyFrameBuilder::Params::Load(deployment, task));
    RecordedTracks tracks(recording, task.scene_objects, task.layout, {});
    std::vector<key_frame_t> frames;
    while (const auto now = tracks.Next()) {
      for (const KeyFrame& frame : builder.Update(*now)) {
        frames.push_back(KeyFrameToMessage(frame));
      }
    }
    return frames;
  }
};

TEST_F(RecordingOfARun, GivesTheKeyFramesOfItsLog) {
  ASSERT_EQ(
      Cell("sim --seed 5 --demonstration two_pegs+two_pegs --out run").code, 0);
  const auto of_log = KeyFramesOfTheLog();
  ASSERT_GT(of_log.size(), 15u);
  const RunFolder run = RunFolder::Open((dir_ / "run").string());
  std::vector<key_frame_t> exact, rounded;
  for (const int episode : {1, 2}) {
    const Recording recording = RecordingOfRun(run, episode, "test");
    EXPECT_EQ(recording.seed, episode == 1 ? 5u : 6u);
    EXPECT_EQ(recording.demonstration, "two_pegs");
    for (const auto& [decimals, frames] :
         {std::pair{std::optional<int>(), &exact}, {5, &rounded}}) {
      const std::string text = RecordingToText(recording, decimals);
      const auto of_text =
          KeyFramesOf(RecordingFromText(text, "text"), run.deployment);
      frames->insert(frames->end(), of_text.begin(), of_text.end());
    }
  }
  ASSERT_EQ(exact.size(), of_log.size());
  ASSERT_EQ(rounded.size(), of_log.size());
  for (size_t i = 0; i < of_log.size(); ++i) {
    EXPECT_EQ(Bus::Encode(exact[i]), Bus::Encode(of_log[i])) << i;
    EXPECT_EQ(rounded[i].header.utime, of_log[i].header.utime) << i;
    for (size_t r = 0; r < of_log[i].relations.size(); ++r) {
      EXPECT_EQ(rounded[i].relations[r].relation,
                of_log[i].relations[r].relation)
          << i << " " << r;
    }
  }
  const ShellResult none = Cell("sec record run --episode 3 --out c.recording");
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.output, HasSubstr("the log has no episode 3"));
  EXPECT_EQ(Cell("sec record run --out a.recording").code, 0);
  EXPECT_EQ(Cell("sec record run --out b.recording --episode 2").code, 0);
  EXPECT_EQ(Cell("sec record run --out b.recording").code, 1);
}

using RecordingsMadeTwice = RunCell;

/// Of one machine: physics is not compared across machines.
TEST_F(RecordingsMadeTwice, AreTheSameAndTeachTheSame) {
  for (const std::string turn : {"a", "b"}) {
    const ShellResult run =
        Cell("learn sec --simulate --seed 11 --recordings " + turn + " --out " +
             turn + ".yaml");
    ASSERT_EQ(run.code, 0) << run.output;
  }
  int num_recordings = 0;
  for (const auto& entry : std::filesystem::directory_iterator(dir_ / "a")) {
    const std::string text = TextOf(entry.path());
    EXPECT_EQ(text, TextOf(dir_ / "b" / entry.path().filename()))
        << entry.path();
    EXPECT_GT(text.size(), 1000u) << entry.path();
    ++num_recordings;
  }
  EXPECT_EQ(num_recordings, 5);
  EXPECT_EQ(TextOf(dir_ / "a.yaml"), TextOf(dir_ / "b.yaml"));
  EXPECT_THAT(TextOf(dir_ / "a.yaml"), HasSubstr("assembly 11"));
}

}  // namespace
}  // namespace cell
