// A folder of recorded frames as a device.
#include "services/camera_set/recorded_frames.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "cell/tick_t.hpp"
#include "common/bus/stepper.h"
#include "common/config/config.h"
#include "common/imaging/png_file.h"
#include "services/camera_set/camera_set.h"
#include "services/camera_set/recorded_device.h"
#include "tests/test_folder.h"

namespace cell {

using namespace camera_set;
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

// Two PNG frames, a.* and c.*, and a cloud between them, each of 3 x 2 pixels;
// the depth of the first pixel tells them apart.
class Recorded : public testing::Test {
 protected:
  Recorded() {
    dir_ = NewTestFolder();
    Write("camera.yaml",
          "{fx: 590, fy: 610, cx: 1, cy: 0.5, depth_unit_mm: 1}\n");
    WriteFrame("a", 1000);
    WriteFrame("c", 3000);
    Write("b.pcd",
          "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\n"
          "COUNT 1 1 1 1\nWIDTH 3\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\n"
          "POINTS 6\nDATA ascii\n"
          "0 0 2.0004 66051\n0 0 2.1 0\nnan nan nan 0\n"
          "0 0 2.2 0\n0 0 2.3 0\n0 0 99 0\n");
  }
  ~Recorded() override { fs::remove_all(dir_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(dir_ / name) << text;
  }
  void WriteFrame(const std::string& name, uint16_t count, int width = 3,
                  int height = 2) const {
    const auto num = static_cast<size_t>(width * height);
    WritePng(dir_ / (name + ".colour.png"),
             RgbImage{width, height, {num, {10, 20, 30}}});
    WritePng(dir_ / (name + ".depth.png"),
             DepthImage{width, height, std::vector<uint16_t>(num, count)});
  }
  void ExpectFailure(const std::string& what) const {
    EXPECT_THAT(
        [&] {
          RecordedFrames frames(dir_, false);
          while (frames.Next()) {
          }
        },
        ThrowsMessage<std::runtime_error>(HasSubstr(what)));
  }

  fs::path dir_;
};

TEST_F(Recorded, AreShownInTheOrderOfTheirNamesOnceOrForEver) {
  for (const bool is_loop : {false, true}) {
    RecordedFrames frames(dir_, is_loop);
    EXPECT_EQ(frames.size(), 3u);
    std::vector<int> seen;
    for (int i = 0; i < 5; ++i) {
      const auto frame = frames.Next();
      seen.push_back(frame ? frame->depth.counts[0] : -1);
    }
    EXPECT_EQ(seen, is_loop ? (std::vector{1000, 2000, 3000, 1000, 2000})
                            : (std::vector{1000, 2000, 3000, -1, -1}));
  }
}

TEST_F(Recorded, AreTakenAsCameraYamlSays) {
  RecordedFrames frames(dir_, false);
  const auto png = frames.Next();
  ASSERT_TRUE(png.has_value());
  EXPECT_EQ(png->view.width, 3);
  EXPECT_EQ(png->view.height, 2);
  EXPECT_EQ(png->view.fy, 610);
  EXPECT_EQ(png->depth_unit, 1e-3);
  EXPECT_THAT(png->colour.pixels[5], testing::ElementsAre(10, 20, 30));
  const auto cloud = frames.Next();
  ASSERT_TRUE(cloud.has_value());
  EXPECT_THAT(cloud->depth.counts,
              testing::ElementsAre(2000, 2100, 0, 2200, 2300, 0));
  EXPECT_THAT(cloud->colour.pixels[0], testing::ElementsAre(1, 2, 3));
}

TEST_F(Recorded, NameTheFileThatIsMissing) {
  fs::remove(dir_ / "c.colour.png");
  ExpectFailure("c.colour.png: is missing");
  fs::remove(dir_ / "c.depth.png");
  fs::remove(dir_ / "a.depth.png");
  ExpectFailure("a.depth.png: is missing");
  fs::remove(dir_ / "camera.yaml");
  ExpectFailure("camera.yaml");
  fs::remove_all(dir_);
  ExpectFailure("is not a folder");
  fs::create_directories(dir_);
  Write("camera.yaml", "{fx: 590, fy: 610, cx: 1, cy: 0.5, depth_unit_mm: 1}");
  ExpectFailure("holds no frame");
}

TEST_F(Recorded, NameTheFileOfAnotherSize) {
  WriteFrame("c", 3000, 2, 3);
  ExpectFailure("c: has 2 x 3 pixels, the frames before it 3 x 2");
  WritePng(dir_ / "c.depth.png", DepthImage{3, 2, std::vector<uint16_t>(6, 1)});
  ExpectFailure("c.depth.png: has 3 x 2 pixels, its colour 2 x 3");
}

TEST_F(Recorded, NameTheFileThatIsDamaged) {
  fs::resize_file(dir_ / "c.depth.png", 30);
  ExpectFailure("c.depth.png: ");
  WriteFrame("c", 3000);
  Write("b.pcd", "nothing of the kind");
  ExpectFailure("b.pcd: ");
  const std::string header =
      "VERSION .7\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\n";
  Write("b.pcd", header +
                     "FIELDS x y z rgb\nWIDTH 6\nHEIGHT 1\nPOINTS 6\n"
                     "DATA ascii\n0 0 1 0\n");
  ExpectFailure("b.pcd: ");
  Write("b.pcd",
        "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\n"
        "COUNT 1 1 1 1\nWIDTH 3000000\nHEIGHT 2000000\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 6000000000000\n"
        "DATA binary\n");
  ExpectFailure("b.pcd: ");
  Write("b.pcd",
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
        "COUNT 1 1 1\nWIDTH 3\nHEIGHT 2\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 6\nDATA ascii\n0 0 1\n");
  ExpectFailure("b.pcd: lacks colour");
}

// A cloud of 3 x 2 points, of which one line of the header is another.
std::string Cloud(const std::string& line = "", const std::string& data = "") {
  const std::string key = line.substr(0, line.find(' '));
  std::string text;
  for (const std::string entry :
       {"VERSION .7", "FIELDS x y z rgb", "SIZE 4 4 4 4", "TYPE F F F U",
        "COUNT 1 1 1 1", "WIDTH 3", "HEIGHT 2", "VIEWPOINT 0 0 0 1 0 0 0",
        "POINTS 6", "DATA ascii"}) {
    const bool is_other = entry.substr(0, entry.find(' ')) == key;
    text += (is_other ? line : entry) + "\n";
  }
  const std::string six =
      "0 0 1 0\n0 0 1 0\n0 0 1 0\n0 0 1 0\n0 0 1 0\n0 0 1 0\n";
  return text + (data.empty() ? six : data);
}

TEST_F(Recorded, EveryClaimOfACloudIsChecked) {
  const std::string point(16, 'a');
  const std::string points(96, 'a');
  const std::string sizes("\x10\0\0\0\x60\0\0\0", 8);
  const std::pair<std::string, std::string> cases[] = {
      {Cloud("COUNT 1 1 1 2000000000"), "COUNT 2000000000"},
      {Cloud("COUNT 1 1 1 -1"), "COUNT '-1' is negative"},
      {Cloud("POINTS 2000000000"), "not an organised cloud"},
      {Cloud("WIDTH 0x3"), "WIDTH '0x3'"},
      {Cloud("WIDTH 03"), "WIDTH '03' has a leading zero"},
      {Cloud("WIDTH 99999999999999999999"), "is out of range"},
      {Cloud("WIDTH"), "WIDTH should be one number"},
      {Cloud("HEIGHT 1"), "not an organised cloud"},
      {Cloud("SIZE 8 4 4 4"), "x is of TYPE F, SIZE 8"},
      {Cloud("TYPE U F F U"), "x is of TYPE U"},
      {Cloud("TYPE Q F F U"), "TYPE Q of SIZE 4"},
      {Cloud("SIZE 4 4 4 1"), "rgb is of SIZE 1"},
      {Cloud("SIZE 4 4 4"), "has 4 FIELDS, 3 SIZEs"},
      {Cloud("FIELDS x y x rgb"), "has the field x twice"},
      {Cloud("FIELDS x y w rgb"), "lacks z"},
      {Cloud("FIELDS x y z w"), "lacks colour"},
      {Cloud("DATA base64"), "DATA 'base64' is not one of"},
      {Cloud("", "0 0 1,5 0\n"), "line 11: z cannot be '1,5'"},
      {Cloud("", "0 0 1.5x 0\n"), "line 11: z cannot be '1.5x'"},
      {Cloud("", "0 0 1 -3\n"), "line 11: rgb cannot be '-3'"},
      {Cloud("", "0 0 1 4294967296\n"), "rgb cannot be '4294967296'"},
      {Cloud("", "0 0 1\n"), "line 11: ends before rgb"},
      {Cloud("", "0 0 1 0 7\n"), "line 11: has 5 values"},
      {Cloud("", "0 0 1 0\n0 0 1 0\n"), "has 2 points, its header claims 6"},
      {Cloud() + "0 0 1 0\n", "has 7 points"},
      {Cloud("DATA binary", point),
       "claims 96 bytes of points, 16 are present"},
      {Cloud("DATA binary", points + "xyz"), "has 3 bytes after its points"},
      {Cloud("DATA binary_compressed", "abc"), "cut off"},
      {Cloud("DATA binary_compressed", std::string(8, 'a')), "claims 16"},
      {Cloud("DATA binary_compressed", sizes + "abc"), "is cut off"},
  };
  for (const auto& [text, what] : cases) {
    Write("b.pcd", text);
    ExpectFailure("b.pcd: ");
    ExpectFailure(what);
  }
}

TEST_F(Recorded, AreInTheOrderOfTheirNumbers) {
  for (const char* name : {"a", "c"}) {
    fs::remove(dir_ / (std::string(name) + ".colour.png"));
    fs::remove(dir_ / (std::string(name) + ".depth.png"));
  }
  fs::remove(dir_ / "b.pcd");
  for (uint16_t i = 0; i < 12; ++i) {
    WriteFrame("frame" + std::to_string(i) + "_x",
               static_cast<uint16_t>(i + 1));
  }
  RecordedFrames frames(dir_, false);
  for (uint16_t i = 0; i < 12; ++i) {
    EXPECT_EQ(frames.Next()->depth.counts[0], i + 1);
  }
}

TEST_F(Recorded, ACloudInMillimetresIsRefusedByName) {
  std::string data;
  for (int i = 0; i < 5; ++i) data += "0 0 850.5 0\n";
  Write("b.pcd", Cloud("", data + "nan nan nan 0\n"));
  ExpectFailure("b.pcd: 5 of its 6 points lie beyond 65.535 m, none within");
}

TEST_F(Recorded, WhatYieldsNoMeasurementIsSaidOnceWithItsCounts) {
  WriteFrame("a", 0);
  Write("b.pcd", Cloud("",
                       "0 0 1 0\n0 0 99 0\n0 0 -1 0\n0 0 0 0\n"
                       "nan nan nan 0\n0 0 2 0\n"));
  RecordedFrames frames(dir_, true);
  std::vector<std::string> remarks;
  for (int i = 0; i < 6; ++i) {
    frames.Next();
    remarks.push_back(frames.remark());
  }
  EXPECT_THAT(remarks[0], HasSubstr("a: none of its 6 pixels was measured"));
  EXPECT_THAT(remarks[1], HasSubstr("b.pcd: of 6 points 1 lie beyond 65.535 m "
                                    "and 2 not in front of the camera"));
  for (int i = 2; i < 6; ++i) EXPECT_EQ(remarks[i], "");
}

TEST_F(Recorded, APictureEndsWhereItsFileDoes) {
  std::ofstream(dir_ / "c.depth.png", std::ios::app) << "more";
  ExpectFailure("c.depth.png: is cut off, or has bytes after its end");
}

TEST_F(Recorded, AFrameIsThereAsACloudOrAsPictures) {
  WriteFrame("b", 1);
  ExpectFailure("b.pcd: the same frame also exists as a picture");
}

TEST_F(Recorded, MisspeltKeysAreNamed) {
  Write("camera.yaml",
        "{fx: 590, fy: 610, cx: 1, cy: 0.5, depth_unit_mm: 1, fz: 3}\n");
  EXPECT_THAT([&] { RecordedFrames(dir_, false); },
              ThrowsMessage<ConfigError>(HasSubstr("camera.yaml:fz")));
}

// As a slow service, which only messages wake.
TEST_F(Recorded, LeaveOnePerPeriodAsIfTheyWereTakenNow) {
  Stepper bus({.name = "camera_set@2", .latency = 4});
  RecordedDevice::Params device;
  device.camera = "2";
  device.folder = dir_;
  device.is_loop = false;
  CameraSet::Params params;
  params.camera = "2";
  params.period_ticks = 12;
  params.phase_ticks = 4;
  const CameraSet set(bus, params,
                      std::make_unique<RecordedDevice>(bus, device));
  std::vector<std::pair<int32_t, int64_t>> seen;
  tick_t beat{};
  for (int32_t tick = 0; tick < 60; ++tick) {
    beat.header.tick = tick;
    const auto input = MessageFromWire(kTickChannel, Bus::Encode(beat));
    if (bus.Accept(tick, {*input}) != Stepper::State::kReady) continue;
    for (const Message& message : bus.Run()) {
      if (message.channel != "FRAME_2") continue;
      rgbd_frame_t frame{};
      frame.decode(message.bytes->data(), 0,
                   static_cast<int>(message.bytes->size()));
      seen.emplace_back(frame.header.utime / kTickUs,
                        FrameFromMessage(frame)->depth.counts[0]);
    }
  }
  EXPECT_THAT(seen, testing::ElementsAre(testing::Pair(4, 1000),
                                         testing::Pair(16, 2000),
                                         testing::Pair(28, 3000)));
}

}  // namespace
}  // namespace cell
