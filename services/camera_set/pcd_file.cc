// The only source that includes PCL's headers.
#include "services/camera_set/pcd_file.h"

#include <fmt/format.h>
#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
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

/// What the header announces, read by hand: PCL's reader makes room for it
/// before it can be asked.
void CheckSize(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) Fail(path, "cannot be opened");
  int64_t width = 0;
  int64_t height = 0;
  int64_t num_points = 0;
  std::string line;
  while (std::getline(file, line) && !line.starts_with("DATA")) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "WIDTH") words >> width;
    if (key == "HEIGHT") words >> height;
    if (key == "POINTS") words >> num_points;
  }
  if (height <= 1 || !IsPictureSize(width, height) ||
      num_points != width * height) {
    Fail(path, fmt::format("is no organised cloud of at most {} points: "
                           "{} x {}, {} in all",
                           kMaxPixels, width, height, num_points));
  }
}

void CheckFields(const std::filesystem::path& path) {
  pcl::PCLPointCloud2 header;
  if (pcl::PCDReader().readHeader(path.string(), header) != 0) {
    Fail(path, "is no PCD file");
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
  CheckSize(path);
  CheckFields(path);
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
