// The only source that includes PCL's headers.
#include "services/camera_set/pcd_file.h"

#include <fmt/format.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "services/camera_set/file_error.h"
#include "services/camera_set/pcd_header.h"

namespace cell::camera_set {
namespace {

// Beyond the range of any depth camera [m].
constexpr double kFarthest = 100;

pcl::PointCloud<pcl::PointXYZRGB> Load(const std::filesystem::path& path) {
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  try {
    if (pcl::io::loadPCDFile(path.string(), cloud) != 0) {
      FailFile(path, "is damaged");
    }
  } catch (const pcl::PCLException& e) {
    FailFile(path, e.what());
  }
  return cloud;
}

}  // namespace

PcdImage ReadPcd(const std::filesystem::path& path, double depth_unit) {
  // PCL would print messages of its own.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const PcdHeader header = CheckPcd(path);
  const auto cloud = Load(path);
  const int width = static_cast<int>(header.width);
  const int height = static_cast<int>(header.height);
  if (cloud.size() != static_cast<size_t>(header.num_points())) {
    FailFile(path, "is damaged");
  }
  const double range = std::min(65535 * depth_unit, kFarthest);
  PcdImage image{{width, height, {}}, {width, height, {}}, {}};
  for (const pcl::PointXYZRGB& point : cloud) {
    const double count = std::round(point.z / depth_unit);
    const bool is_measured = point.z <= range && count >= 1 && count <= 65535;
    image.depth.counts.push_back(is_measured ? static_cast<uint16_t>(count)
                                             : uint16_t{0});
    image.colour.pixels.push_back({point.r, point.g, point.b});
    if (!std::isfinite(point.z)) continue;
    image.lost.num_beyond += point.z > range;
    image.lost.num_behind += count < 1;
  }
  const bool is_any =
      std::any_of(image.depth.counts.begin(), image.depth.counts.end(),
                  [](uint16_t count) { return count > 0; });
  if (!is_any && image.lost.num_beyond > 0) {
    FailFile(path,
             fmt::format("{} of its {} points lie beyond {} m, none within: "
                         "x, y, z should be in m (camera.yaml: depth_unit_mm "
                         "{})",
                         image.lost.num_beyond, cloud.size(), range,
                         1e3 * depth_unit));
  }
  image.lost.range = range;
  return image;
}

}  // namespace cell::camera_set
