#include "common/recordings/recording_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "common/geometry/pose.h"

namespace cell {
namespace {

using testing::HasSubstr;

constexpr char kHead[] =
    "cell-recording 1\n"
    "task blocks\n"
    "demonstration stack\n"
    "build 0.1\n"
    "seed 7\n"
    "body block\n"
    "body hand.palm\n";

Recording Walk(int num_frames) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  Recording recording{
      "blocks",
      "stack",
      7,
      "0.1",
      {"block", "hand.palm"},
      {},
      {{5, "Lift"}, {400, "Lower"}},
      {{7, Recording::TrueAction::Kind::kPlaced, "block", "a.b"},
       {400, Recording::TrueAction::Kind::kTipped, "block", ""}}};
  std::vector<std::optional<pose_t>> poses(2);
  for (int i = 0; i < num_frames; ++i) {
    const int moved = i % 3;
    if (moved < 2) {
      const auto q = Eigen::Quaterniond(normal(random), normal(random),
                                        normal(random), normal(random))
                         .normalized();
      Eigen::Isometry3d X_WB(q);
      X_WB.translation() << normal(random), normal(random), normal(random);
      poses[moved] = PoseToMessage(X_WB);
    } else if (i % 9 == 8) {
      poses[0].reset();
    }
    recording.frames.push_back({100 * i, poses});
  }
  return recording;
}

bool Same(const pose_t& a, const pose_t& b, double tolerance) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(a.position[i] - b.position[i]) > tolerance) return false;
  }
  for (int i = 0; i < 4; ++i) {
    if (std::abs(a.quat_wxyz[i] - b.quat_wxyz[i]) > tolerance) return false;
  }
  return true;
}

void ExpectSame(const Recording& a, const Recording& b, double tolerance) {
  EXPECT_EQ(a.task, b.task);
  EXPECT_EQ(a.demonstration, b.demonstration);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.build, b.build);
  EXPECT_EQ(a.bodies, b.bodies);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (size_t i = 0; i < a.frames.size(); ++i) {
    EXPECT_EQ(a.frames[i].utime, b.frames[i].utime);
    for (size_t k = 0; k < a.bodies.size(); ++k) {
      const auto& p = a.frames[i].poses[k];
      const auto& q = b.frames[i].poses[k];
      ASSERT_EQ(p.has_value(), q.has_value()) << i;
      EXPECT_TRUE(!p || Same(*p, *q, tolerance)) << i;
    }
  }
  ASSERT_EQ(a.spoken.size(), b.spoken.size());
  for (size_t i = 0; i < a.spoken.size(); ++i) {
    EXPECT_EQ(a.spoken[i].utime, b.spoken[i].utime);
    EXPECT_EQ(a.spoken[i].name, b.spoken[i].name);
  }
  EXPECT_EQ(a.truth, b.truth);
}

TEST(RecordingText, ComesBackAsItWentInBitForBit) {
  const Recording recording = Walk(50);
  ExpectSame(
      RecordingFromText(RecordingToText(recording, std::nullopt), "text"),
      recording, 0);
}

TEST(RecordingText, ComesBackRoundedToTheDecimals) {
  const Recording recording = Walk(50);
  const std::string text = RecordingToText(recording, 3);
  const Recording back = RecordingFromText(text, "text");
  ExpectSame(back, recording, 0.5e-3 + 1e-12);
  EXPECT_EQ(RecordingToText(back, 3), text);
  EXPECT_LT(text.size(), RecordingToText(recording, std::nullopt).size() / 2);
}

TEST(RecordingText, WhatRestsTakesNoRow) {
  Recording recording = Walk(3);
  recording.spoken.clear();
  recording.truth.clear();
  const size_t size = RecordingToText(recording, 5).size();
  recording.frames.push_back({10'000, recording.frames.back().poses});
  EXPECT_EQ(RecordingToText(recording, 5).size(),
            size + std::string("frame 10000\n").size());
}

TEST(RecordingText, ARowMayLeaveOutTheRotation) {
  const Recording recording =
      RecordingFromText(std::string(kHead) +
                            "# moves, then is taken away\n\n"
                            "frame 1\n0 0.5 0 0 0 1 0 0\nframe 2\n0 0.6 0 0\n"
                            "frame 3\n0 gone\nend 3\n",
                        "text");
  ASSERT_EQ(recording.frames.size(), 3u);
  EXPECT_EQ(recording.frames[1].poses[0]->position[0], 0.6);
  EXPECT_EQ(recording.frames[1].poses[0]->quat_wxyz[1], 1);
  EXPECT_FALSE(recording.frames[2].poses[0]);
  EXPECT_FALSE(recording.frames[2].poses[1]);
}

struct Broken {
  const char* rows;  // after kHead, whose last line is 7
  const char* error;
};

TEST(RecordingText, ABadTextIsRefusedWithItsLineAndWhatWouldBeRight) {
  const std::vector<Broken> cases = {
      {"frame 1\n", "text:8: the file is cut off"},
      {"body block\nend 0\n", "text:8: a second body 'block'"},
      {"colour red\n", "text:8: 'colour' is not known here"},
      {"seed x\n", "text:8: seed 'x' is not a whole number"},
      {"task blocks\n", "text:8: a second 'task'"},
      {"frame\n", "text:8: must read 'frame UTIME'"},
      {"frame -1\n", "text:8: time -1 is not between"},
      {"frame 2\nframe 2\n", "text:9: frame 2 is not later than the last"},
      {"frame 1\nbody cup\n", "text:9: body 'body' is not a whole number"},
      {"frame 1\n2 0 0 0\n", "text:9: body 2 is not there"},
      {"frame 1\n0 0 0 0\n", "text:9: the first row of a body must have"},
      {"frame 1\n0 0 0 0 1 0\n", "text:9: must read 'BODY x y z"},
      {"frame 1\n0 0 0 nan 1 0 0 0\n", "text:9: position 'nan' is not a"},
      {"frame 1\n0 0 0 0 1 1 0 0\n", "text:9: is no pose"},
      {"frame 1\n0 0 0 999 1 0 0 0\n", "text:9: is no pose"},
      {"frame 1\n0 0  0 0 1 0 0 0\n", "text:9: must read 'BODY x y z"},
      {"frame 1\n0 gone\n0 gone\n", "text:10: a second row of body 0"},
      {"said 1\n", "text:8: must read 'said UTIME NAME'"},
      {"said 2 A\nsaid 1 B\n", "text:9: said at 1, but the name before"},
      {"truth 1 placed block\n", "text:8: must read 'truth UTIME placed"},
      {"truth 1 moved block a.b\n", "text:8: must read 'truth UTIME placed"},
      {"truth 1 eaten block\n", "text:8: must read 'truth UTIME placed"},
      {"truth 2 moved a\ntruth 1 moved a\n", "text:9: truth at 1, but the"},
      {"frame 1\nend 2\n", "text:9: says that there are 2 frames"},
      {"end 0\nframe 1\n", "text:9: nothing may follow 'end'"}};
  for (const Broken& broken : cases) {
    try {
      RecordingFromText(std::string(kHead) + broken.rows, "text");
      ADD_FAILURE() << broken.rows;
    } catch (const RecordingError& error) {
      EXPECT_THAT(error.what(), HasSubstr(broken.error));
    }
  }
}

TEST(RecordingText, AnotherFormatAndVersionAreNamed) {
  const auto error = [](const std::string& text) -> std::string {
    try {
      RecordingFromText(text, "text");
    } catch (const RecordingError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error(""), HasSubstr("text:1: is no recording"));
  EXPECT_THAT(error("PNG\n"), HasSubstr("text:1: is no recording"));
  EXPECT_THAT(error("cell-recording 2\n"),
              HasSubstr("text:1: has version 2 of the format"));
  EXPECT_THAT(error("cell-recording 1\nend 0\n"),
              HasSubstr("text:2: no line 'task NAME'"));
}

TEST(RecordingText, WhatCannotBeReadIsNotWritten) {
  Recording recording = Walk(3);
  recording.bodies[0] = "a block";
  EXPECT_THROW(RecordingToText(recording, 5), std::invalid_argument);
  recording = Walk(3);
  recording.frames[1].poses.pop_back();
  EXPECT_THROW(RecordingToText(recording, 5), std::invalid_argument);
  recording = Walk(3);
  recording.frames[2].utime = recording.frames[1].utime;
  EXPECT_THROW(RecordingToText(recording, 5), std::invalid_argument);
}

}  // namespace
}  // namespace cell
