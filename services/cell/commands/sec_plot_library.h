#pragma once

#include <string>

namespace cell::cli {

struct LibraryPlotOptions {
  std::string database;  ///< empty: the models that the task comes with
  std::string deploy_dir;
  std::string out;
};

/// Draws a library as a picture: `cell sec plot --library`. Returns 0.
int PlotLibrary(const LibraryPlotOptions& options);

}  // namespace cell::cli
