#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/sec/event_chain.h"
#include "common/sec/library_members.h"
#include "services/cell/pictures/canvas.h"

namespace cell::cli {

/// A library of SEC models: how alike its models are, and of each its event
/// chain, the demonstrations that are its members, and how alike these are
/// (section VI-A); the histogram of all members' similarities, with Otsu's
/// bound and tau. Similarities are matrices by rows, from 0 to 1.
struct LibraryFigure {
  using Similarities = std::vector<std::vector<double>>;
  struct Model {
    std::string name;
    EventChain chain;
    std::vector<std::string> members;
    Similarities of_members;
  };

  std::vector<Model> models;
  Similarities of_models;
  /// From which on showings are of one action. Framed: models that are as
  /// similar, and members that are not.
  double threshold = 0;
  /// Of all members; drawn if it has pairs.
  MemberHistogram of_members = {};
};

/// [px] Width and height.
std::array<int, 2> SizeOf(const LibraryFigure& figure);

/// @throws std::invalid_argument unless each matrix is as large as what it
/// compares.
void DrawLibrary(const LibraryFigure& figure, Canvas* canvas);

}  // namespace cell::cli
