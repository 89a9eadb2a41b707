#include "services/cell/pictures/chain_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "services/cell/pictures/relation_colour.h"
#include "services/cell/pictures/text_drawing.h"

namespace cell::cli {
namespace {

constexpr int kGap = 12;
constexpr int kRowHeight = 28;   // height of a line of text
constexpr int kMinColumn = 200;  // width
constexpr int kGraph = 200;      // width and height of a main graph
constexpr int kNode = 15;        // radius
constexpr Canvas::Colour kEdgeColour = {40, 40, 40},
                         kRuleColour = {200, 200, 200};

/// Distinct for the first ten.
Canvas::Colour ColourOf(size_t node) {
  constexpr std::array<Canvas::Colour, 10> kColours = {{{230, 120, 110},
                                                        {120, 180, 230},
                                                        {140, 200, 120},
                                                        {240, 200, 90},
                                                        {190, 140, 220},
                                                        {120, 210, 200},
                                                        {240, 160, 200},
                                                        {180, 180, 180},
                                                        {210, 170, 130},
                                                        {160, 160, 240}}};
  return kColours[node % kColours.size()];
}

/// Where the figure's pieces are.
struct FigureLayout {
  explicit FigureLayout(const ChainFigure& figure) {
    for (const auto& [a, b] : figure.chain.pairs()) {
      objects.push_back(a);
      objects.push_back(b);
      label_width = std::max(label_width, WidthOf(a + ", " + b));
    }
    std::ranges::sort(objects);
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    if (!figure.pictures.empty()) {
      column_width = std::max(column_width, figure.pictures[0].width);
      graphs_y += figure.pictures[0].height + kGap;
    }
    matrix_y = graphs_y + kGap +
               std::max(kGraph, static_cast<int>(objects.size()) * kRowHeight);
  }

  int X(size_t column) const {
    return label_width + 2 * kGap +
           static_cast<int>(column) * (column_width + kGap);
  }
  int Y(size_t row) const {
    return matrix_y + static_cast<int>(row) * kRowHeight;
  }
  static int WidthOf(const std::string& text) { return TextSize(text, 2)[0]; }

  std::vector<std::string> objects;  // sorted; nodes of the graphs
  int label_width = 0;
  int column_width = kMinColumn;
  int graphs_y = kGap + kRowHeight;
  int matrix_y = 0;
};

void DrawNames(const ChainFigure& figure, const FigureLayout& layout,
               Canvas* canvas) {
  for (size_t i = 0; i < layout.objects.size(); ++i) {
    const int y =
        layout.graphs_y + static_cast<int>(i) * kRowHeight + kRowHeight / 2;
    canvas->Disc(kGap + kNode, y, kNode - 2, ColourOf(i));
    canvas->CentredText(kGap + kNode, y, std::to_string(i + 1));
    canvas->Text(2 * kGap + 2 * kNode, y, layout.objects[i]);
  }
  for (size_t row = 0; row < figure.chain.num_rows(); ++row) {
    const auto& [a, b] = figure.chain.pairs()[row];
    canvas->Text(kGap, layout.Y(row) + kRowHeight / 2, a + ", " + b);
  }
}

void DrawGraph(const ChainFigure& figure, const FigureLayout& layout,
               size_t column, Canvas* canvas) {
  const size_t num = layout.objects.size();
  const int x = layout.X(column) + layout.column_width / 2;
  const int y = layout.graphs_y + kGraph / 2;
  const auto place = [&](size_t node) -> std::array<int, 2> {
    const double angle = 2 * std::numbers::pi * static_cast<double>(node) /
                         static_cast<double>(num);
    const double radius = kGraph / 2.0 - kNode;
    return {x + static_cast<int>(radius * std::sin(angle)),
            y - static_cast<int>(radius * std::cos(angle))};
  };
  const auto node_of = [&](const std::string& name) {
    return static_cast<size_t>(std::ranges::lower_bound(layout.objects, name) -
                               layout.objects.begin());
  };
  for (size_t row = 0; row < figure.chain.num_rows(); ++row) {
    const Relation relation = figure.chain.At(row, column);
    const bool is_inside = relation == Relation::kOverlapping;
    if (relation != Relation::kTouching && !is_inside) continue;
    const auto& [a, b] = figure.chain.pairs()[row];
    const auto from = place(node_of(a)), to = place(node_of(b));
    canvas->Line(from[0], from[1], to[0], to[1], is_inside ? 6 : 3,
                 kEdgeColour);
  }
  for (size_t node = 0; node < num; ++node) {
    const auto [node_x, node_y] = place(node);
    canvas->Disc(node_x, node_y, kNode, ColourOf(node));
    canvas->CentredText(node_x, node_y, std::to_string(node + 1));
  }
}

void DrawColumn(const ChainFigure& figure, const FigureLayout& layout,
                size_t column, Canvas* canvas) {
  const int x = layout.X(column), middle = x + layout.column_width / 2;
  canvas->CentredText(middle, kGap + kRowHeight / 2, figure.titles[column]);
  if (!figure.pictures.empty()) {
    canvas->Picture(x, kGap + kRowHeight, figure.pictures[column]);
  }
  DrawGraph(figure, layout, column, canvas);
  for (size_t row = 0; row < figure.chain.num_rows(); ++row) {
    const Relation relation = figure.chain.At(row, column);
    canvas->Rectangle(x, layout.Y(row) + 1, layout.column_width, kRowHeight - 2,
                      ColourOfRelation(relation));
    canvas->CentredText(middle, layout.Y(row) + kRowHeight / 2,
                        std::to_string(static_cast<int>(relation)));
  }
}

void RequireSound(const ChainFigure& figure) {
  const size_t num = figure.chain.num_columns();
  const bool has_pictures =
      figure.pictures.empty() || figure.pictures.size() == num;
  if (figure.titles.size() == num && has_pictures) return;
  throw std::invalid_argument(
      fmt::format("a figure of {} columns has {} titles and {} pictures", num,
                  figure.titles.size(), figure.pictures.size()));
}

}  // namespace

std::array<int, 2> SizeOf(const ChainFigure& figure) {
  const FigureLayout layout(figure);
  return {layout.X(figure.chain.num_columns()),
          layout.Y(figure.chain.num_rows()) + kGap};
}

void DrawChain(const ChainFigure& figure, Canvas* canvas) {
  RequireSound(figure);
  const FigureLayout layout(figure);
  DrawNames(figure, layout, canvas);
  for (size_t i = 0; i < figure.chain.num_columns(); ++i) {
    canvas->Line(layout.X(i) - kGap / 2, kGap, layout.X(i) - kGap / 2,
                 layout.Y(figure.chain.num_rows()), 1, kRuleColour);
    DrawColumn(figure, layout, i, canvas);
  }
}

}  // namespace cell::cli
