// What is written into pictures: labels, and what the grey of depth means.
#include <gtest/gtest.h>

#include <algorithm>

#include "services/cell/pictures/frame_picture.h"
#include "services/cell/pictures/text_drawing.h"

namespace cell::cli {
namespace {

constexpr std::array<uint8_t, 3> kGreen = {0, 255, 0};

RgbImage Green(int width, int height) {
  RgbImage image{width, height, {}};
  image.pixels.assign(static_cast<size_t>(width) * static_cast<size_t>(height),
                      kGreen);
  return image;
}

TEST(TextDrawing, WritesInkOnAPlateOfTheSizeThatItSays) {
  RgbImage picture = Green(200, 40);
  const auto [width, height] = TextSize("shaft", 2);
  DrawText("shaft", 10, 5, 2, &picture);
  int num_changed = 0, num_dark = 0;
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 200; ++column) {
      const auto& pixel =
          picture.pixels[static_cast<size_t>(row * 200 + column)];
      const bool is_on_plate =
          column >= 10 && column < 10 + width && row >= 5 && row < 5 + height;
      EXPECT_EQ(pixel != kGreen, is_on_plate) << column << " " << row;
      num_changed += pixel != kGreen;
      num_dark += pixel[0] < 100 && pixel != kGreen;
    }
  }
  EXPECT_GT(num_dark, num_changed / 20);
  EXPECT_LT(num_dark, num_changed / 2);
}

TEST(TextDrawing, CutsOffWhatLiesOutside) {
  RgbImage picture = Green(20, 10);
  DrawText("round_peg_1", -15, -3, 3, &picture);
  DrawText("round_peg_1", 15, 8, 3, &picture);
  EXPECT_EQ(picture.pixels.size(), 200u);
}

RgbdFrame FrameOf(uint16_t near, uint16_t far) {
  RgbdFrame frame;
  frame.depth_unit = 1e-3;
  frame.depth = {320, 100, std::vector<uint16_t>(32'000, far)};
  std::fill_n(frame.depth.counts.begin(), 16'000, near);
  frame.depth.counts[0] = 0;
  return frame;
}

TEST(DepthPicture, IsBrightWhereItIsNearAndBlackWhereNothingWasMeasured) {
  const RgbImage picture = GreyOfDepth(FrameOf(800, 1600));
  EXPECT_EQ(picture.pixels[0][0], 0);
  EXPECT_EQ(picture.pixels[1][0], 255);
  EXPECT_LT(picture.pixels[320 * 60][0], 100);
}

TEST(DepthPicture, SaysAtItsFootWhatTheGreyMeans) {
  const auto foot = [](const RgbImage& picture) {
    return std::vector(picture.pixels.end() - 320 * 30, picture.pixels.end());
  };
  EXPECT_NE(foot(GreyOfDepth(FrameOf(800, 1600))),
            foot(GreyOfDepth(FrameOf(800, 1700))));
  EXPECT_NE(foot(GreyOfDepth(FrameOf(800, 1600))),
            foot(GreyOfDepth(FrameOf(900, 1600))));
}

}  // namespace
}  // namespace cell::cli
