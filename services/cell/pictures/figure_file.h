#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string_view>

#include "services/cell/pictures/canvas.h"

namespace cell::cli {

/// A figure as a new PNG or SVG file, by the extension of its name.
struct FigureFile {
  std::filesystem::path path;
  std::string_view advice;  ///< ends the error if the file is there already

  /// @throws std::invalid_argument for another extension, std::runtime_error
  /// if the file exists.
  void Require() const;
  /// @param size  [px] width and height
  /// @throws std::runtime_error if the file exists or cannot be written.
  void Write(const std::array<int, 2>& size,
             const std::function<void(Canvas*)>& draw) const;
};

}  // namespace cell::cli
