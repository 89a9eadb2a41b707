#include "services/cell/pictures/library_figure.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

#include "services/cell/pictures/raster_canvas.h"
#include "services/cell/pictures/svg_canvas.h"

namespace cell {

using namespace cli;
namespace {

using testing::HasSubstr;

LibraryFigure TwoModels() {
  LibraryFigure figure;
  EventChain chain;
  chain.Append({{{"bolt", "table"}, Relation::kTouching}});
  chain.Append({{{"bolt", "table"}, Relation::kAbsent}});
  figure.models = {{"Insert", chain, {"first", "second"}, {{1, 0.5}, {0.5, 1}}},
                   {"Turn", chain, {"third"}, {{1}}}};
  figure.of_models = {{1, 0.7}, {0.7, 1}};
  figure.threshold = 0.6;
  return figure;
}

int CountIn(const std::string& text, const std::string& word) {
  int count = 0;
  for (size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

std::string SvgOf(const LibraryFigure& figure) {
  const auto [width, height] = SizeOf(figure);
  SvgCanvas canvas(width, height);
  DrawLibrary(figure, &canvas);
  return canvas.ToText();
}

TEST(LibraryFigure, ShowsModelsChainsMembersAndAllSimilarities) {
  const std::string svg = SvgOf(TwoModels());
  EXPECT_EQ(CountIn(svg, ">1 Insert<"), 2);  // of the matrix, and of its chain
  EXPECT_THAT(svg, HasSubstr(">2 second<"));
  EXPECT_THAT(svg, HasSubstr(">bolt, table<"));
  EXPECT_EQ(CountIn(svg, ">9<"), 2);
  EXPECT_EQ(CountIn(svg, ">0.70<"), 2);
  EXPECT_EQ(CountIn(svg, ">1.00<"), 2 + 2 + 1);
}

TEST(LibraryFigure, FramesModelsThatAreAlikeAndMembersThatAreNot) {
  EXPECT_EQ(CountIn(SvgOf(TwoModels()), "<line"), 4 * (2 + 2));
  LibraryFigure figure = TwoModels();
  figure.threshold = 0.4;
  EXPECT_EQ(CountIn(SvgOf(figure), "<line"), 4 * 2);
  figure.threshold = 0.8;
  EXPECT_EQ(CountIn(SvgOf(figure), "<line"), 4 * 2);
}

/// 4 pairs of one action, 2 of two.
LibraryFigure WithHistogram() {
  LibraryFigure figure = TwoModels();
  figure.of_members.of_one[18] = 4;
  figure.of_members.of_two[3] = 2;
  figure.of_members.cut = 0.55;
  figure.of_members.tau = 0.92;
  return figure;
}

TEST(LibraryFigure, ShowsTheHistogramWithItsBoundsIfThereIsOne) {
  EXPECT_THAT(SvgOf(TwoModels()), testing::Not(HasSubstr("Otsu")));
  const std::string svg = SvgOf(WithHistogram());
  EXPECT_THAT(svg, HasSubstr("6 pairs"));
  EXPECT_THAT(svg, HasSubstr("bound 0.55"));
  EXPECT_THAT(svg, HasSubstr("tau 0.92"));
  EXPECT_EQ(CountIn(svg, "<line"), CountIn(SvgOf(TwoModels()), "<line") + 2);
  EXPECT_GT(SizeOf(WithHistogram())[1], SizeOf(TwoModels())[1]);
}

TEST(LibraryFigure, AsPixelsFitsItsSize) {
  const auto [width, height] = SizeOf(WithHistogram());
  RasterCanvas canvas(width, height);
  DrawLibrary(WithHistogram(), &canvas);
  for (int x = 0; x < width; ++x) {
    const auto last = static_cast<size_t>((height - 1) * width + x);
    EXPECT_EQ(canvas.image().pixels[last], canvas.image().pixels.back());
  }
}

TEST(LibraryFigure, RefusesSimilaritiesOfAnotherNumber) {
  SvgCanvas canvas(100, 100);
  LibraryFigure figure = TwoModels();
  figure.of_models.pop_back();
  EXPECT_THROW(DrawLibrary(figure, &canvas), std::invalid_argument);
  figure = TwoModels();
  figure.models[0].of_members[1].clear();
  EXPECT_THROW(DrawLibrary(figure, &canvas), std::invalid_argument);
}

}  // namespace
}  // namespace cell
