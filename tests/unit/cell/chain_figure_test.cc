#include "services/cell/pictures/chain_figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "services/cell/pictures/raster_canvas.h"
#include "services/cell/pictures/svg_canvas.h"

namespace cell {

using namespace cli;
namespace {

using testing::HasSubstr;
using testing::Not;

ChainFigure TwoColumns() {
  ChainFigure figure;
  TouchGraph graph = {{{"block", "hand<1>"}, Relation::kNotTouching},
                      {{"block", "table"}, Relation::kTouching}};
  figure.chain.Append(graph);
  graph[{"block", "hand<1>"}] = Relation::kOverlapping;
  graph[{"block", "table"}] = Relation::kAbsent;
  figure.chain.Append(graph);
  figure.titles = {"0.00 s", "1.50 s"};
  return figure;
}

std::string Svg(const ChainFigure& figure) {
  const auto [width, height] = SizeOf(figure);
  SvgCanvas canvas(width, height);
  DrawChain(figure, &canvas);
  return canvas.ToText();
}

int CountOf(const std::string& text, const std::string& word) {
  int count = 0;
  for (size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(ChainFigure, AsSvgHasEveryEntryAndEveryNode) {
  const std::string svg = Svg(TwoColumns());
  EXPECT_THAT(svg, HasSubstr(">1.50 s<"));
  EXPECT_THAT(svg, HasSubstr(">block, table<"));
  EXPECT_EQ(CountOf(svg, ">9<"), 1);
  EXPECT_EQ(CountOf(svg, "<circle"), 3 + 2 * 3);     // legend, and two graphs
  EXPECT_EQ(CountOf(svg, "stroke-width=\"3\""), 1);  // touching
  EXPECT_EQ(CountOf(svg, "stroke-width=\"6\""), 1);  // overlapping
  EXPECT_EQ(CountOf(svg, "<image"), 0);
}

TEST(ChainFigure, NamesAreEscaped) {
  EXPECT_THAT(Svg(TwoColumns()), HasSubstr("hand&lt;1&gt;"));
  EXPECT_THAT(Svg(TwoColumns()), Not(HasSubstr("hand<1>")));
}

TEST(ChainFigure, PicturesAreEmbeddedAsPng) {
  ChainFigure figure = TwoColumns();
  const auto height = SizeOf(figure)[1];
  RgbImage picture{30, 20, {}};
  picture.pixels.assign(600, {255, 0, 0});
  figure.pictures = {picture, picture};
  EXPECT_GT(SizeOf(figure)[1], height + 20);
  // Bytes 0x89 P N G \r \n in base64.
  EXPECT_EQ(CountOf(Svg(figure), "href=\"data:image/png;base64,iVBORw0K"), 2);
}

TEST(ChainFigure, AsPixelsShowsThePictureWhereItIsInTheSvg) {
  ChainFigure figure = TwoColumns();
  constexpr std::array<uint8_t, 3> kRed = {255, 0, 0};
  RgbImage picture{30, 20, {}};
  picture.pixels.assign(600, kRed);
  figure.pictures = {picture, picture};
  const auto [width, height] = SizeOf(figure);
  RasterCanvas canvas(width, height);
  DrawChain(figure, &canvas);
  EXPECT_EQ(canvas.image().width, width);
  EXPECT_EQ(std::ranges::count(canvas.image().pixels, kRed), 2 * 600);
}

TEST(ChainFigure, RefusesPicturesAndTitlesOfOtherColumns) {
  ChainFigure figure = TwoColumns();
  figure.titles.pop_back();
  EXPECT_THROW(Svg(figure), std::invalid_argument);
  figure = TwoColumns();
  figure.pictures.resize(1);
  EXPECT_THROW(Svg(figure), std::invalid_argument);
}

TEST(RasterCanvas, CutsOffWhatLiesOutside) {
  RasterCanvas canvas(10, 10);
  canvas.Rectangle(-5, -5, 100, 7, {1, 2, 3});
  canvas.Line(-50, 5, 50, 5, 1, {4, 5, 6});
  canvas.Disc(9, 9, 3, {7, 8, 9});
  EXPECT_EQ(canvas.image().pixels[10][0], 1);
  EXPECT_EQ(canvas.image().pixels[20][0], 255);
  EXPECT_EQ(canvas.image().pixels[50][0], 4);
  EXPECT_EQ(canvas.image().pixels[99][0], 7);
}

}  // namespace
}  // namespace cell
