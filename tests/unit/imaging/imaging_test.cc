// Pictures as bytes: what is decoded is what was encoded, and forged bytes are
// refused.
#include <gmock/gmock.h>
#include <zstd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "common/geometry/pose.h"
#include "common/imaging/colour_codec.h"
#include "common/imaging/depth_codec.h"
#include "common/imaging/png_file.h"
#include "common/imaging/rgbd_frame.h"
#include "tests/test_folder.h"

namespace cell {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

constexpr int kWidth = 64;
constexpr int kHeight = 48;

// A slanted plane with a box and a hole in it.
DepthImage AScene(int width = kWidth, int height = kHeight) {
  DepthImage image{width, height, {}};
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const bool is_box = u > 20 && u < 40 && v > 10 && v < 30;
      const bool is_hole = u == 5;
      const int count = is_hole ? 0 : (is_box ? 9000 : 12000) - 17 * v + u / 3;
      image.counts.push_back(static_cast<uint16_t>(count));
    }
  }
  return image;
}

RgbImage AColourScene(uint64_t seed = 0) {
  std::mt19937_64 random(seed);
  RgbImage image{kWidth, kHeight, {}};
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const auto grey =
        static_cast<uint8_t>(seed == 0 ? i / kWidth * 4 : random() % 256);
    image.pixels.push_back({grey, 100, static_cast<uint8_t>(255 - grey)});
  }
  return image;
}

RgbdFrame AFrame() {
  RgbdFrame frame;
  frame.utime = 96'000;
  frame.camera = "2";
  frame.view.width = kWidth;
  frame.view.height = kHeight;
  frame.view.X_WC = Eigen::Translation3d(0.1, 0.2, 1.3) *
                    Eigen::AngleAxisd(2, Eigen::Vector3d::UnitX());
  frame.colour = AColourScene();
  frame.depth = AScene();
  return frame;
}

TEST(DepthCodec, GivesBackExactlyWhatItTook) {
  std::mt19937_64 random(7);
  for (const auto& [width, height] :
       {std::pair{1, 1}, {1, 9}, {9, 1}, {kWidth, kHeight}, {641, 3}}) {
    const auto num = static_cast<size_t>(width * height);
    DepthImage noise{width, height, std::vector<uint16_t>(num)};
    for (uint16_t& count : noise.counts) {
      count = static_cast<uint16_t>(random());
    }
    const DepthImage least{width, height, std::vector<uint16_t>(num, 0)};
    const DepthImage most{width, height, std::vector<uint16_t>(num, 65535)};
    for (const DepthImage& image :
         {AScene(width, height), noise, least, most}) {
      const auto decoded = DecodeDepth(EncodeDepth(image), width, height);
      ASSERT_TRUE(decoded.has_value()) << width << " x " << height;
      EXPECT_EQ(decoded->counts, image.counts);
      EXPECT_EQ(EncodeDepth(image), EncodeDepth(image));
    }
  }
}

TEST(DepthCodec, TakesLessThanAQuarterOfASmoothScene) {
  EXPECT_THAT(EncodeDepth(AScene(640, 480)),
              SizeIs(testing::Lt(640u * 480 * 2 / 4)));
}

TEST(DepthCodec, RefusesBytesOfOtherPicturesAndBytesCutShort) {
  const auto bytes = EncodeDepth(AScene());
  EXPECT_FALSE(DecodeDepth(bytes, kWidth, kHeight + 1));
  EXPECT_FALSE(DecodeDepth(bytes, kWidth - 1, kHeight));
  EXPECT_FALSE(DecodeDepth(bytes, 0, 0));
  EXPECT_FALSE(DecodeDepth(bytes, -kWidth, -kHeight));
  EXPECT_FALSE(DecodeDepth(bytes, 1 << 20, 1 << 20));
  EXPECT_FALSE(DecodeDepth({}, kWidth, kHeight));
  for (size_t n = 0; n < bytes.size(); n += 7) {
    EXPECT_FALSE(DecodeDepth(std::span(bytes).first(n), kWidth, kHeight)) << n;
  }
}

// 1 GB of zeros in some 30 KB.
TEST(DepthCodec, DoesNotUnpackMoreThanThePicture) {
  std::vector<uint8_t> bytes;
  const std::vector<uint8_t> zeros(1 << 20);
  std::vector<uint8_t> packed(ZSTD_compressBound(zeros.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(),
                              zeros.size(), 1));
  for (int i = 0; i < 1024; ++i) {
    bytes.insert(bytes.end(), packed.begin(), packed.end());
  }
  EXPECT_FALSE(DecodeDepth(bytes, kWidth, kHeight));
}

TEST(DepthCodec, RefusesCountsThatFillNoPicture) {
  EXPECT_THROW(EncodeDepth({2, 2, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(EncodeDepth({}), std::invalid_argument);
}

TEST(ColourCodec, GivesBackNearlyWhatItTook) {
  const RgbImage image = AColourScene();
  const auto bytes = EncodeColour(image, 95);
  EXPECT_EQ(bytes, EncodeColour(image, 95));
  const auto decoded = DecodeColour(bytes, kWidth, kHeight);
  ASSERT_TRUE(decoded.has_value());
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    for (size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(decoded->pixels[i][c], image.pixels[i][c], 12) << i;
    }
  }
  EXPECT_LT(EncodeColour(AColourScene(1), 20).size(),
            EncodeColour(AColourScene(1), 90).size());
}

TEST(ColourCodec, RefusesBytesOfOtherPicturesAndBytesCutShort) {
  const auto bytes = EncodeColour(AColourScene(), 90);
  EXPECT_FALSE(DecodeColour(bytes, kWidth, kHeight + 8));
  EXPECT_FALSE(DecodeColour(bytes, 0, 0));
  EXPECT_FALSE(DecodeColour(bytes, 1 << 20, 1 << 20));
  EXPECT_FALSE(DecodeColour({}, kWidth, kHeight));
  for (size_t n = 0; n + 2 < bytes.size(); n += 7) {
    EXPECT_FALSE(DecodeColour(std::span(bytes).first(n), kWidth, kHeight)) << n;
  }
}

TEST(RgbdFrame, SurvivesItsMessage) {
  const RgbdFrame frame = AFrame();
  const auto message = FrameToMessage(frame, 150'000, 90);
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->header.utime, 96'000);
  const auto decoded = FrameFromMessage(*message);
  ASSERT_TRUE(decoded.has_value());
  EXPECT_EQ(decoded->utime, frame.utime);
  EXPECT_EQ(decoded->camera, "2");
  EXPECT_EQ(decoded->depth_unit, frame.depth_unit);
  EXPECT_EQ(decoded->depth.counts, frame.depth.counts);
  EXPECT_THAT(decoded->colour.pixels, SizeIs(kWidth * kHeight));
  EXPECT_EQ(decoded->view.fx, frame.view.fx);
  EXPECT_EQ(decoded->view.cy, frame.view.cy);
  EXPECT_TRUE(decoded->view.X_WC.isApprox(frame.view.X_WC, 1e-12));
}

TEST(RgbdFrame, GivesUpColourBeforeItGetsTooLongAndDepthNever) {
  RgbdFrame frame = AFrame();
  frame.colour = AColourScene(3);
  const auto best = FrameToMessage(frame, 150'000, 90);
  const int full = best->getEncodedSize();
  const auto shorter = FrameToMessage(frame, full - 1, 90);
  ASSERT_TRUE(shorter.has_value());
  EXPECT_LT(shorter->getEncodedSize(), full);
  EXPECT_EQ(shorter->depth, best->depth);
  EXPECT_FALSE(FrameToMessage(frame, best->num_depth_bytes, 90));
}

TEST(RgbdFrame, RefusesWhatCannotBe) {
  const auto good = *FrameToMessage(AFrame(), 150'000, 90);
  ASSERT_TRUE(FrameFromMessage(good));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<void (*)(rgbd_frame_t&)> forgeries = {
      [](rgbd_frame_t& m) { m.width = -m.width; },
      [](rgbd_frame_t& m) { m.width = m.height = 0; },
      [](rgbd_frame_t& m) { m.width = m.height = 1 << 30; },
      [](rgbd_frame_t& m) { std::swap(m.width, m.height); },
      [](rgbd_frame_t& m) { m.fx = 0; },
      [](rgbd_frame_t& m) { m.fy = kNan; },
      [](rgbd_frame_t& m) { m.cx = kNan; },
      [](rgbd_frame_t& m) { m.pose_world_camera.quat_wxyz[0] = 7; },
      [](rgbd_frame_t& m) { m.depth_unit = -1e-4; },
      [](rgbd_frame_t& m) { m.depth_format = 1; },
      [](rgbd_frame_t& m) { m.colour_format = -1; },
      [](rgbd_frame_t& m) { m.depth.pop_back(); },
      [](rgbd_frame_t& m) { m.depth.swap(m.colour); },
      [](rgbd_frame_t& m) {
        m.colour.resize(m.colour.size() / 2);
      }};
  for (size_t i = 0; i < forgeries.size(); ++i) {
    rgbd_frame_t forged = good;
    forgeries[i](forged);
    EXPECT_FALSE(FrameFromMessage(forged)) << "forgery " << i;
  }
}

// Whatever a flipped byte does, what comes out is a picture or nothing.
TEST(RgbdFrame, OfFlippedBytesIsAPictureOrNothing) {
  const auto good = *FrameToMessage(AFrame(), 150'000, 90);
  std::mt19937_64 random(11);
  int num_refused = 0;
  constexpr int kNumForgeries = 5000;
  for (int i = 0; i < kNumForgeries; ++i) {
    rgbd_frame_t forged = good;
    auto& bytes = i % 2 == 0 ? forged.depth : forged.colour;
    for (uint64_t n = random() % 4; n < 4; ++n) {
      bytes[random() % bytes.size()] ^= static_cast<uint8_t>(random() % 256);
    }
    const auto frame = FrameFromMessage(forged);
    num_refused += !frame;
    if (!frame) continue;
    EXPECT_THAT(frame->depth.counts, SizeIs(kWidth * kHeight));
    EXPECT_THAT(frame->colour.pixels, SizeIs(kWidth * kHeight));
  }
  EXPECT_GT(num_refused, kNumForgeries / 10);
}

class PngFile : public testing::Test {
 protected:
  ~PngFile() override { std::filesystem::remove_all(dir_); }

  std::filesystem::path dir_ = NewTestFolder();
};

TEST_F(PngFile, ReadsAsItWasWritten) {
  WritePng(dir_ / "c.png", AColourScene());
  WritePng(dir_ / "d.png", AScene());
  EXPECT_EQ(ReadColourPng(dir_ / "c.png").pixels, AColourScene().pixels);
  EXPECT_EQ(ReadColourPng(dir_ / "c.png").width, kWidth);
  EXPECT_EQ(ReadDepthPng(dir_ / "d.png").counts, AScene().counts);
  EXPECT_EQ(ReadDepthPng(dir_ / "d.png").height, kHeight);
  EXPECT_THROW(WritePng("/nowhere/at/all.png", AScene()), std::runtime_error);
}

TEST_F(PngFile, NamesTheFileThatIsNone) {
  WritePng(dir_ / "c.png", AColourScene());
  EXPECT_THAT([&] { ReadDepthPng(dir_ / "c.png"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("c.png: is not a")));
  EXPECT_THAT([&] { ReadColourPng(dir_ / "none.png"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("none.png: ")));
  std::filesystem::resize_file(dir_ / "c.png", 100);
  EXPECT_THAT([&] { ReadColourPng(dir_ / "c.png"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("c.png: ")));
}

}  // namespace
}  // namespace cell
