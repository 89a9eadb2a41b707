// LCM's own tools with the cell's messages and logs.
#include <gmock/gmock.h>
#include <lodepng.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class StockTools : public RunCell {};

TEST_F(StockTools, LcmSpyDecodesAndShowsWhatLcmLogplayerPlays) {
  const ShellResult sim = Cell("sim --seed 3 --demonstration two_pegs --out a");
  ASSERT_EQ(sim.code, 0) << sim.output;
  // Stays for a person to look at.
  const std::string picture = CELL_PICTURES_DIR "/lcm_spy.png";
  fs::create_directories(CELL_PICTURES_DIR);
  fs::remove(picture);
  const ShellResult spy =
      Shell(InPrivateNetwork() + CELL_SOURCE_DIR "/tests/system/spy/" +
            "look_with_spy " + kCell + " " +
            (dir_ / "a" / "cell-0001.lcmlog").string() +
            " " CELL_SPY_PROBE " TRACKS " + picture);
  ASSERT_EQ(spy.code, 0) << spy.output;
  EXPECT_THAT(spy.output, HasSubstr("row TICK tick_t"));
  EXPECT_THAT(spy.output, HasSubstr("row ARM_STATE_LEFT arm_state_t"));
  EXPECT_THAT(spy.output, HasSubstr("row TRACKS tracks_t"));
  EXPECT_THAT(spy.output, HasSubstr("decoded cell.tracks_t"));
  EXPECT_THAT(spy.output, testing::ContainsRegex("field num_tracks [1-9]"));

  std::vector<unsigned char> pixels;
  unsigned width = 0, height = 0;
  ASSERT_EQ(lodepng::decode(pixels, width, height, picture), 0u);
  std::map<uint32_t, size_t> num_of_colour;
  for (size_t i = 0; i < pixels.size(); i += 4) {
    ++num_of_colour[uint32_t{pixels[i]} << 16 | uint32_t{pixels[i + 1]} << 8 |
                    pixels[i + 2]];
  }
  size_t most = 0;
  for (const auto& [colour, num] : num_of_colour) most = std::max(most, num);
  EXPECT_GE(num_of_colour.size(), 20u) << "the screen is blank";
  EXPECT_LT(most, size_t{width} * height * 9 / 10) << "the screen is blank";
}

TEST_F(StockTools, WithoutJavaOrItsJarsSpySaysWhatToInstall) {
  const ShellResult spy = Cell("spy --root /nowhere");
  EXPECT_EQ(spy.code, 1);
  for (const char* package :
       {"openjdk-17-jre", "liblcm-java", "libjchart2d-java"}) {
    EXPECT_THAT(spy.output, HasSubstr(std::string("fix: apt-get install -y "
                                                  "--no-install-recommends ") +
                                      package));
  }
}

}  // namespace
}  // namespace cell
