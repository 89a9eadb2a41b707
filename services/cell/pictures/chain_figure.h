#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/imaging/rgb_image.h"
#include "common/sec/event_chain.h"
#include "services/cell/pictures/canvas.h"

namespace cell::cli {

/// An event chain as in the paper's Fig. 8: above each column its key frame as
/// a picture and its main graph, in which nodes are objects and edges join
/// those that touch; below, the matrix.
struct ChainFigure {
  EventChain chain;
  std::vector<std::string> titles;  ///< of each column
  std::vector<RgbImage> pictures;   ///< of each column, of one size; or none
};

/// [px] Width and height.
std::array<int, 2> SizeOf(const ChainFigure& figure);

/// @throws std::invalid_argument unless there is a title, and a picture or
/// none, for each column.
void DrawChain(const ChainFigure& figure, Canvas* canvas);

}  // namespace cell::cli
