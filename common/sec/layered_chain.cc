#include "common/sec/layered_chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace cell {
namespace {

// The columns that DistinctColumns() keeps.
std::vector<size_t> DistinctOf(const EventChain& rows) {
  std::vector<size_t> columns;
  for (size_t column = 0; column < rows.num_columns(); ++column) {
    bool is_new = column == 0;
    for (size_t row = 0; row < rows.num_rows() && !is_new; ++row) {
      is_new = rows.At(row, column) != rows.At(row, column - 1);
    }
    if (is_new) columns.push_back(column);
  }
  return columns;
}

Motion LastMotion(std::span<const RelationLayers> layers,
                  const ObjectPair& pair) {
  Motion last = Motion::kNone;
  for (const RelationLayers& of_column : layers) {
    const Motion motion = of_column.MotionOf(pair.first, pair.second);
    if (motion != Motion::kNone) last = motion;
  }
  return last;
}

std::string SignsOf(Place place, Motion motion) {
  constexpr std::string_view kPlaces = ".ihocab";
  constexpr std::string_view kMotions = ".><=";
  std::string signs;
  if (place != Place::kNone) signs += kPlaces.at(static_cast<size_t>(place));
  if (motion != Motion::kNone) {
    signs += kMotions.at(static_cast<size_t>(motion));
  }
  return signs;
}

}  // namespace

LayeredChain EnrichedRowsOf(const std::string& part, const EventChain& chain,
                            std::span<const RelationLayers> layers) {
  if (layers.size() != chain.num_columns()) {
    throw std::invalid_argument(
        fmt::format("layers of {} key frames for a chain of {}", layers.size(),
                    chain.num_columns()));
  }
  const EventChain rows = chain.RowsOf(part).ChangingRows();
  const std::vector<size_t> columns = DistinctOf(rows);
  LayeredChain enriched{part, rows.DistinctColumns(), {}, {}};
  for (const ObjectPair& pair : rows.pairs()) {
    const std::string& other = pair.first == part ? pair.second : pair.first;
    auto& places = enriched.places.emplace_back();
    auto& motions = enriched.motions.emplace_back();
    size_t next = 0;
    for (const size_t column : columns) {
      places.push_back(layers[column].PlaceOf(part, other));
      motions.push_back(
          LastMotion(layers.subspan(next, column + 1 - next), pair));
      next = column + 1;
    }
  }
  return enriched;
}

std::string ToText(const LayeredChain& chain) {
  const EventChain& touching = chain.touching;
  size_t width = 0;
  for (const auto& [first, second] : touching.pairs()) {
    width = std::max(width, first.size() + 2 + second.size());
  }
  std::string text;
  for (size_t row = 0; row < touching.num_rows(); ++row) {
    const auto& [first, second] = touching.pairs()[row];
    std::string line = fmt::format("{:{}} ", first + ", " + second, width);
    for (size_t column = 0; column < touching.num_columns(); ++column) {
      line += fmt::format(
          " {:3}",
          fmt::format(
              "{}{}", static_cast<int>(touching.At(row, column)),
              SignsOf(chain.places[row][column], chain.motions[row][column])));
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace cell
