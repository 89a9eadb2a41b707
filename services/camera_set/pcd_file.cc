// The only source that includes PCL's headers.
#include "services/camera_set/pcd_file.h"

#include <fmt/format.h>
#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cell {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path,
                       const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}

bool HasField(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  return std::any_of(cloud.fields.begin(), cloud.fields.end(),
                     [&](const auto& field) { return field.name == name; });
}

/// Looks at the header before room is made for what it announces.
void CheckHeader(const std::filesystem::path& path) {
  pcl::PCLPointCloud2 header;
  if (pcl::PCDReader().readHeader(path.string(), header) != 0) {
    Fail(path, "is missing or no PCD file");
  }
  if (header.height <= 1 || !IsPictureSize(header.width, header.height)) {
    Fail(path,
         fmt::format("is no organised cloud of at most {} points: {} x {}",
                     kMaxPixels, header.width, header.height));
  }
  for (const char* name : {"x", "y", "z"}) {
    if (!HasField(header, name)) Fail(path, fmt::format("lacks {}", name));
  }
  if (!HasField(header, "rgb") && !HasField(header, "rgba")) {
    Fail(path, "lacks colour: rgb or rgba");
  }
}

pcl::PointCloud<pcl::PointXYZRGB> Load(const std::filesystem::path& path) {
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  try {
    if (pcl::io::loadPCDFile(path.string(), cloud) != 0) {
      Fail(path, "is damaged");
    }
  } catch (const pcl::PCLException& e) {
    Fail(path, e.what());
  }
  return cloud;
}

}  // namespace

PcdImage ReadPcd(const std::filesystem::path& path, double depth_unit) {
  // It would speak to the person by itself.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  CheckHeader(path);
  const auto cloud = Load(path);
  const int width = static_cast<int>(cloud.width);
  const int height = static_cast<int>(cloud.height);
  if (cloud.size() != size_t{cloud.width} * cloud.height) {
    Fail(path, "is damaged");
  }
  PcdImage image{{width, height, {}}, {width, height, {}}};
  for (const pcl::PointXYZRGB& point : cloud) {
    const double count = std::round(point.z / depth_unit);
    const bool is_measured = count >= 1 && count <= 65535;
    image.depth.counts.push_back(is_measured ? static_cast<uint16_t>(count)
                                             : uint16_t{0});
    image.colour.pixels.push_back({point.r, point.g, point.b});
  }
  return image;
}

}  // namespace cell
