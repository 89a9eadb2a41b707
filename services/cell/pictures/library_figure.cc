#include "services/cell/pictures/library_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "services/cell/pictures/relation_colour.h"
#include "services/cell/pictures/text_drawing.h"

namespace cell::cli {
namespace {

constexpr int kMargin = 12;
constexpr int kLine = 28;  // height of a line of text, and of a cell
constexpr int kNumTitleLines = 2;
constexpr int kValueWidth = 96;  // of a cell with a similarity
constexpr int kEntryWidth = 44;  // of a cell with a relation
constexpr Canvas::Colour kFrameColour = {200, 30, 30};
constexpr int kBarWidth = 40;     // of a bin of the histogram
constexpr int kBarsHeight = 112;  // of the highest bar
constexpr int kHistogramLines = 8;
constexpr int kHistogramWidth =
    2 * kMargin + static_cast<int>(MemberHistogram::kNumBins) * kBarWidth;
constexpr Canvas::Colour kOfOneColour = {90, 185, 110};
constexpr Canvas::Colour kOfTwoColour = {150, 150, 160};
constexpr Canvas::Colour kCutColour = {40, 80, 190};

std::string LabelOf(const ObjectPair& pair) {
  return pair.first + ", " + pair.second;
}

std::string LabelOf(size_t number, const std::string& name) {
  return fmt::format("{} {}", number + 1, name);
}

int WidthOfText(const std::string& text) {
  return TextSize(text, 2)[0];
}

/// From white, nothing in common, to a full green.
Canvas::Colour ColourOf(double similarity) {
  const double share = std::clamp(similarity, 0.0, 1.0);
  const auto mix = [&](int end) {
    return static_cast<uint8_t>(std::lround(250 + share * (end - 250)));
  };
  return {mix(90), mix(185), mix(110)};
}

/// Where the figure's pieces are: models by models on top; below the histogram,
/// and for each model a title, its chain on the left, and members by members on
/// the right.
struct LibraryLayout {
  explicit LibraryLayout(const LibraryFigure& figure) {
    size_t num_columns = 0, num_members = 0;
    for (size_t i = 0; i < figure.models.size(); ++i) {
      const LibraryFigure::Model& model = figure.models[i];
      name_width = std::max(name_width, WidthOfText(LabelOf(i, model.name)));
      for (const ObjectPair& pair : model.chain.pairs()) {
        row_width = std::max(row_width, WidthOfText(LabelOf(pair)));
      }
      for (size_t k = 0; k < model.members.size(); ++k) {
        member_width =
            std::max(member_width, WidthOfText(LabelOf(k, model.members[k])));
      }
      num_columns = std::max(num_columns, model.chain.num_columns());
      num_members = std::max(num_members, model.members.size());
    }
    const auto num = [](size_t n) {
      return static_cast<int>(n);
    };
    matrix_x = 2 * kMargin + name_width;
    entries_x = 2 * kMargin + row_width;
    members_x = entries_x + num(num_columns) * kEntryWidth + 3 * kMargin;
    values_x = members_x + member_width + kMargin;
    int y = kMargin + (num(figure.models.size()) + kNumTitleLines + 2) * kLine;
    histogram_y = y;
    if (figure.of_members.num_pairs() > 0) y += kHistogramLines * kLine;
    for (const LibraryFigure::Model& model : figure.models) {
      model_y.push_back(y);
      const size_t lines =
          std::max(model.chain.num_rows(), model.members.size() + 1);
      y += (num(lines) + 1) * kLine + kMargin;
    }
    height = y;
    width = kMargin +
            std::max({matrix_x + num(figure.models.size()) * kValueWidth,
                      values_x + num(num_members) * kValueWidth,
                      figure.of_members.num_pairs() > 0 ? kHistogramWidth : 0});
  }

  int name_width = 0, row_width = 0, member_width = 0;
  int matrix_x = 0, entries_x = 0, members_x = 0, values_x = 0;
  std::vector<int> model_y;  // of its title
  int histogram_y = 0;
  int width = 0, height = 0;
};

void DrawFrame(int x, int y, Canvas* canvas) {
  const int right = x + kValueWidth - 3, bottom = y + kLine - 3;
  for (const auto& [x1, y1, x2, y2] : {std::array{x, y, right, y},
                                       {x, bottom, right, bottom},
                                       {x, y, x, bottom},
                                       {right, y, right, bottom}}) {
    canvas->Line(x1, y1, x2, y2, 2, kFrameColour);
  }
}

/// A matrix below its column numbers. @param is_marked  of two that differ
template <class IsMarked>
void DrawSimilarities(const LibraryFigure::Similarities& similarities, int x,
                      int y, IsMarked is_marked, Canvas* canvas) {
  for (size_t i = 0; i < similarities.size(); ++i) {
    const int left = x + static_cast<int>(i) * kValueWidth;
    canvas->CentredText(left + kValueWidth / 2, y + kLine / 2,
                        std::to_string(i + 1));
    for (size_t j = 0; j < similarities.size(); ++j) {
      const int top = y + static_cast<int>(j + 1) * kLine;
      const double value = similarities[j][i];
      canvas->Rectangle(left, top, kValueWidth - 2, kLine - 2, ColourOf(value));
      canvas->CentredText(left + kValueWidth / 2, top + kLine / 2 - 1,
                          fmt::format("{:.2f}", value));
      if (i != j && is_marked(value)) DrawFrame(left, top, canvas);
    }
  }
}

/// Bars of what is of one action on those of two, and lines at the bounds.
void DrawHistogram(const LibraryFigure& figure, int top, Canvas* canvas) {
  const MemberHistogram& histogram = figure.of_members;
  canvas->Text(
      kMargin, top + kLine / 2,
      fmt::format("{} pairs of what was shown: of one action green, of two "
                  "grey",
                  histogram.num_pairs()));
  canvas->Text(kMargin, top + 3 * kLine / 2,
               fmt::format("Otsu's bound {:.2f} (blue), tau {:.2f}, one action "
                           "from {:.2f} (red)",
                           histogram.cut, histogram.tau, figure.threshold));
  size_t most = 1;
  for (size_t bin = 0; bin < histogram.kNumBins; ++bin) {
    most = std::max(most, histogram.of_one[bin] + histogram.of_two[bin]);
  }
  const auto height_of = [most](size_t num) {
    return static_cast<int>(num * size_t{kBarsHeight} / most);
  };
  const int bottom = top + 2 * kLine + kMargin / 2 + kBarsHeight;
  for (size_t bin = 0; bin < histogram.kNumBins; ++bin) {
    const int x = kMargin + static_cast<int>(bin) * kBarWidth;
    const int of_two = height_of(histogram.of_two[bin]);
    const int of_one = height_of(histogram.of_one[bin]);
    canvas->Rectangle(x, bottom - of_two, kBarWidth - 2, of_two, kOfTwoColour);
    canvas->Rectangle(x, bottom - of_two - of_one, kBarWidth - 2, of_one,
                      kOfOneColour);
    if (bin % 4 == 0) {
      canvas->Text(
          x, bottom + kLine / 2,
          fmt::format("{:.1f}", static_cast<double>(bin) / histogram.kNumBins));
    }
  }
  const auto draw_bound = [&](double at, const Canvas::Colour& colour) {
    const int x =
        kMargin +
        static_cast<int>(std::lround(at * histogram.kNumBins * kBarWidth));
    canvas->Line(x, bottom - kBarsHeight, x, bottom, 2, colour);
  };
  draw_bound(histogram.cut, kCutColour);
  draw_bound(figure.threshold, kFrameColour);
}

void DrawModel(const LibraryFigure& figure, const LibraryLayout& layout,
               size_t number, Canvas* canvas) {
  const LibraryFigure::Model& model = figure.models[number];
  const int title = layout.model_y[number], top = title + kLine;
  canvas->Text(kMargin, title + kLine / 2, LabelOf(number, model.name));
  for (size_t row = 0; row < model.chain.num_rows(); ++row) {
    const int y = top + static_cast<int>(row) * kLine;
    canvas->Text(kMargin, y + kLine / 2, LabelOf(model.chain.pairs()[row]));
    for (size_t column = 0; column < model.chain.num_columns(); ++column) {
      const int x = layout.entries_x + static_cast<int>(column) * kEntryWidth;
      const Relation relation = model.chain.At(row, column);
      canvas->Rectangle(x, y + 1, kEntryWidth - 2, kLine - 2,
                        ColourOfRelation(relation));
      canvas->CentredText(x + kEntryWidth / 2 - 1, y + kLine / 2,
                          std::to_string(static_cast<int>(relation)));
    }
  }
  for (size_t k = 0; k < model.members.size(); ++k) {
    canvas->Text(layout.members_x,
                 top + static_cast<int>(k + 1) * kLine + kLine / 2,
                 LabelOf(k, model.members[k]));
  }
  DrawSimilarities(
      model.of_members, layout.values_x, top,
      [&](double value) { return value < figure.threshold; }, canvas);
}

void RequireSquare(const LibraryFigure::Similarities& similarities, size_t num,
                   const std::string& of) {
  const bool is_square =
      similarities.size() == num &&
      std::ranges::all_of(similarities,
                          [&](const auto& row) { return row.size() == num; });
  if (is_square) return;
  throw std::invalid_argument(
      fmt::format("the similarities of {} are no matrix of {} rows", of, num));
}

}  // namespace

std::array<int, 2> SizeOf(const LibraryFigure& figure) {
  const LibraryLayout layout(figure);
  return {layout.width, layout.height};
}

void DrawLibrary(const LibraryFigure& figure, Canvas* canvas) {
  RequireSquare(figure.of_models, figure.models.size(), "models");
  for (const LibraryFigure::Model& model : figure.models) {
    RequireSquare(model.of_members, model.members.size(), model.name);
  }
  const LibraryLayout layout(figure);
  const std::array lines = {
      fmt::format("one action from {:.2f} on", figure.threshold),
      std::string("framed: models above, members below")};
  for (size_t i = 0; i < lines.size(); ++i) {
    canvas->Text(kMargin, kMargin + static_cast<int>(i) * kLine + kLine / 2,
                 lines[i]);
  }
  const int y = kMargin + kNumTitleLines * kLine;
  for (size_t i = 0; i < figure.models.size(); ++i) {
    canvas->Text(kMargin, y + static_cast<int>(i + 1) * kLine + kLine / 2,
                 LabelOf(i, figure.models[i].name));
  }
  DrawSimilarities(
      figure.of_models, layout.matrix_x, y,
      [&](double value) { return value >= figure.threshold; }, canvas);
  if (figure.of_members.num_pairs() > 0) {
    DrawHistogram(figure, layout.histogram_y, canvas);
  }
  for (size_t i = 0; i < figure.models.size(); ++i) {
    DrawModel(figure, layout, i, canvas);
  }
}

}  // namespace cell::cli
