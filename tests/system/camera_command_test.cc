// The cell with its camera sets, as users run it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "common/bus/run_log.h"
#include "common/imaging/png_file.h"
#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A few seconds of the arms' work, enough for some thirty frames of each set.
class CameraCommand : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    fs::copy(fs::path(CELL_SOURCE_DIR) / "deploy", dir_ / "deploy",
             fs::copy_options::recursive);
    std::ofstream(
        dir_ / "deploy" / "tasks" / "cranfield" / "demonstrators.yaml",
        std::ios::app)
        << "  short: {agent: robot, hands: 0, place: [], max_duration_s: 3}\n";
  }

  static inline const std::string kShort =
      " --deploy deploy --seed 5 --demonstration short ";

  static std::map<std::string, std::string> Digests(const std::string& hash) {
    std::istringstream lines(hash);
    std::map<std::string, std::string> digests;
    std::string channel;
    std::string digest;
    while (lines >> channel >> digest) digests[channel] = digest;
    return digests;
  }
};

TEST_F(CameraCommand, FramesAreTheSameOverLcmAndInOneProcessAndReplay) {
  const std::string lcm = Hash("demo --cameras" + kShort + "--out a");
  const auto digests = Digests(lcm);
  EXPECT_EQ(Digests(Hash("sim --cameras" + kShort + "--out b")), digests);
  for (const char* channel : {"FRAME_1", "FRAME_2", "FRAME_3"}) {
    EXPECT_TRUE(digests.contains(channel)) << channel;
  }
  const RunLog log = RunLog::Load(dir_ / "a");
  EXPECT_THAT(log.problems(), testing::IsEmpty());
  std::map<std::string, int> num_frames;
  for (const auto& [k, tick] : log.ticks()) {
    for (const Message& message : tick.messages) {
      if (!message.channel.starts_with("FRAME_")) continue;
      ++num_frames[message.channel];
      EXPECT_LE(message.bytes->size(), 150'000u);
    }
  }
  ASSERT_EQ(num_frames.size(), 3u);
  for (const auto& [channel, num] : num_frames) EXPECT_GE(num, 25) << channel;
  const ShellResult replay = Cell("replay a --check");
  EXPECT_EQ(replay.code, 0) << replay.output;
  EXPECT_THAT(replay.output, HasSubstr("camera_set@3"));
}

// Without --cameras nothing else of the run changes.
TEST_F(CameraCommand, WithoutCamerasTheRestOfTheRunIsTheSame) {
  auto with = Digests(Hash("sim --cameras" + kShort + "--out a"));
  auto without = Digests(Hash("sim" + kShort + "--out b"));
  EXPECT_THAT(TextOf(dir_ / "b" / "deploy" / "config" / "roster.yaml"),
              HasSubstr("option: cameras"));
  for (const char* channel : {"FRAME_1", "FRAME_2", "FRAME_3"}) {
    EXPECT_EQ(with.erase(channel), 1u);
  }
  // STATUS has rows of all services.
  with.erase("STATUS");
  without.erase("STATUS");
  EXPECT_EQ(with, without);
}

TEST_F(CameraCommand, AKilledSetIsMissedAndComesBack) {
  const ShellResult run =
      Cell("demo --cameras" + kShort + "--out a --kill camera_set@2@150");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("camera_set@2: killed by signal 9, restarted"));
  std::set<int32_t> incarnations;
  const RunLog log = RunLog::Load(dir_ / "a");
  for (const auto& [k, tick] : log.ticks()) {
    for (const Message& message : tick.messages) {
      if (message.channel == "FRAME_2")
        incarnations.insert(message.sender / 1000);
    }
  }
  EXPECT_THAT(incarnations, testing::ElementsAre(0, 1));
  const ShellResult replay = Cell("replay a --check --service camera_set@2");
  EXPECT_EQ(replay.code, 0) << replay.output;
}

TEST_F(CameraCommand, ViewShowsWhatACameraSaw) {
  ASSERT_EQ(Cell("sim --cameras" + kShort + "--out a").code, 0);
  const ShellResult colour = Cell("view a --camera 2 --at 1 --out c.png");
  EXPECT_EQ(colour.code, 0) << colour.output;
  EXPECT_THAT(colour.output, HasSubstr("camera 2 saw at 0."));
  const RgbImage picture = ReadColourPng(dir_ / "c.png");
  EXPECT_EQ(picture.width, 640);
  EXPECT_EQ(picture.height, 480);
  ASSERT_EQ(Cell("view a --camera 2 --depth --at 1 --out d.png").code, 0);
  const RgbImage depth = ReadColourPng(dir_ / "d.png");
  EXPECT_NE(depth.pixels, picture.pixels);
  for (const auto& pixel : depth.pixels) {
    ASSERT_EQ(pixel[0], pixel[1]);
    ASSERT_EQ(pixel[1], pixel[2]);
  }
  EXPECT_THAT(Cell("view a --camera 4").output,
              HasSubstr("no FRAME_4; only runs with --cameras"));
  EXPECT_EQ(Cell("view a --depth").code, 2);
}

// A folder in the task stands in for each set; the run keeps a copy.
TEST_F(CameraCommand, RecordedFoldersAreADeviceToo) {
  for (const char* set : {"1", "2", "3"}) {
    const fs::path folder =
        dir_ / "deploy" / "tasks" / "cranfield" / "recorded" / set;
    fs::create_directories(folder);
    std::ofstream(folder / "camera.yaml")
        << "{fx: 50, fy: 50, cx: 7.5, cy: 5.5, depth_unit_mm: 1}\n";
    WritePng(folder / "0001.colour.png", RgbImage{16, 12, {192, {9, 8, 7}}});
    WritePng(folder / "0001.depth.png",
             DepthImage{16, 12, std::vector<uint16_t>(192, 1500)});
  }
  const fs::path yaml = dir_ / "deploy" / "config" / "camera_set.yaml";
  std::string text = TextOf(yaml);
  text.replace(text.find("device: rendered"), 16, "device: recorded");
  std::ofstream(yaml) << text;
  ASSERT_EQ(Cell("sim --cameras" + kShort + "--out a").code, 0);
  const ShellResult replay = Cell("replay a --check --service camera_set@1");
  EXPECT_EQ(replay.code, 0) << replay.output;
  EXPECT_EQ(Cell("view a --camera 3 --out c.png").code, 0);
  EXPECT_EQ(ReadColourPng(dir_ / "c.png").width, 16);
  fs::remove_all(dir_ / "deploy" / "tasks" / "cranfield" / "recorded" / "2");
  const ShellResult lost = Cell("sim --cameras" + kShort + "--out b");
  EXPECT_EQ(lost.code, 1);
  EXPECT_THAT(lost.output, HasSubstr("recorded/2: is not a folder of frames"));
}

TEST_F(CameraCommand, ARosterWithoutCamerasSaysSo) {
  const fs::path yaml = dir_ / "deploy" / "config" / "roster.yaml";
  const std::string text = TextOf(yaml);
  std::ofstream(yaml) << text.substr(0, text.find("  - {name: camera_set@1"));
  // The supervisor must not wait for services that are not there.
  const fs::path table = dir_ / "deploy" / "config" / "supervisor.yaml";
  const std::string missed = TextOf(table);
  std::ofstream(table) << missed.substr(0, missed.find("  camera_set@1"));
  const ShellResult run = Cell("sim --cameras" + kShort + "--out a");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output,
              HasSubstr("roster.yaml:services: has no service with the option "
                        "cameras"));
}

}  // namespace
}  // namespace cell
