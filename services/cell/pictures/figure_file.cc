#include "services/cell/pictures/figure_file.h"

#include <stdexcept>

#include "common/files/draft.h"
#include "common/imaging/png_file.h"
#include "services/cell/pictures/raster_canvas.h"
#include "services/cell/pictures/svg_canvas.h"

namespace cell::cli {

void FigureFile::Require() const {
  if (path.extension() != ".png" && path.extension() != ".svg") {
    throw std::invalid_argument("--out " + path.string() +
                                ": must end in .png or .svg");
  }
  RequireFree(path, advice);
}

void FigureFile::Write(const std::array<int, 2>& size,
                       const std::function<void(Canvas*)>& draw) const {
  if (path.extension() == ".svg") {
    SvgCanvas canvas(size[0], size[1]);
    draw(&canvas);
    return WriteNewFile(path, canvas.ToText(), advice);
  }
  RasterCanvas canvas(size[0], size[1]);
  draw(&canvas);
  Draft draft(path);
  WritePng(draft.path(), canvas.image());
  draft.PutNew(advice);
}

}  // namespace cell::cli
