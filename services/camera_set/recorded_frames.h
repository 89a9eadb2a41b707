#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/imaging/rgbd_frame.h"

namespace cell::camera_set {

/// A folder of recorded frames, device adapter: <name>.colour.png (8 bits) with
/// <name>.depth.png (16 bits of grey), or <name>.pcd (an organised cloud in C),
/// in the order of their names with numbers by their value (2 before 10), and
/// camera.yaml, how they were taken:
///
///   {fx: 589.4, fy: 609.3, cx: 319.5, cy: 239.5, depth_unit_mm: 0.1}
///
/// depth_unit_mm: of the counts of <name>.depth.png, and of what is made of
/// clouds.
class RecordedFrames {
 public:
  /// @throws std::runtime_error naming the folder or the file if there is no
  /// frame, one lacks a half or is there as a cloud besides, ConfigError for
  /// camera.yaml.
  RecordedFrames(std::filesystem::path folder, bool is_loop);

  /// The next frame without utime, camera and X_WC; nothing when all have been
  /// and it does not begin again.
  /// @throws std::runtime_error naming the file if it is missing, damaged, or
  /// not of the size of the frames before.
  std::optional<RgbdFrame> Next();

  size_t size() const { return names_.size(); }

  /// Content of the last frame that yields no measurement but may be meant as
  /// one, with file and counts; empty if none, or if reported before.
  const std::string& remark() const { return remark_; }

 private:
  RgbdFrame Load(const std::string& name);
  RgbdFrame LoadCloud(const std::filesystem::path& path);

  std::filesystem::path folder_;
  bool is_loop_;
  Camera view_;  // its size is that of the first frame
  bool has_size_ = false;
  double depth_unit_ = 1e-3;
  std::vector<std::string> names_;
  size_t next_ = 0;
  std::string remark_;
  std::set<std::string> remarked_;  // names
};

}  // namespace cell::camera_set
