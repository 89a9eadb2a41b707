#include "services/camera_set/recorded_frames.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <utility>

#include "common/config/config.h"
#include "common/imaging/png_file.h"
#include "services/camera_set/pcd_file.h"

namespace cell {
namespace {

namespace fs = std::filesystem;

constexpr char kColour[] = ".colour.png";
constexpr char kDepth[] = ".depth.png";
constexpr char kCloud[] = ".pcd";

[[noreturn]] void Fail(const fs::path& path, const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}

std::string SizeText(int width, int height) {
  return fmt::format("{} x {} pixels", width, height);
}

}  // namespace

RecordedFrames::RecordedFrames(fs::path folder, bool is_loop)
    : folder_(std::move(folder)), is_loop_(is_loop) {
  if (!fs::is_directory(folder_)) Fail(folder_, "is no folder of frames");
  const Config config = Config::Load((folder_ / "camera.yaml").string());
  view_.fx = config.Number("fx", 1, 1e5);
  view_.fy = config.Number("fy", 1, 1e5);
  view_.cx = config.Number("cx", -1e5, 1e5);
  view_.cy = config.Number("cy", -1e5, 1e5);
  depth_unit_ = 1e-3 * config.Number("depth_unit_mm", 1e-3, 100);
  config.Finish();
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string file = entry.path().filename().string();
    for (const std::string ending : {kColour, kDepth, kCloud}) {
      if (!file.ends_with(ending)) continue;
      names.insert(file.substr(0, file.size() - ending.size()));
    }
  }
  if (names.empty()) Fail(folder_, "holds no frame");
  names_.assign(names.begin(), names.end());
  for (const std::string& name : names_) {
    if (fs::exists(folder_ / (name + kCloud))) continue;
    for (const char* half : {kColour, kDepth}) {
      const fs::path path = folder_ / (name + half);
      if (!fs::exists(path)) Fail(path, "is missing; its other half is there");
    }
  }
}

std::optional<RgbdFrame> RecordedFrames::Next() {
  if (next_ == names_.size()) {
    if (!is_loop_) return std::nullopt;
    next_ = 0;
  }
  const std::string& name = names_[next_++];
  RgbdFrame frame = Load(name);
  if (!has_size_) {
    view_.width = frame.depth.width;
    view_.height = frame.depth.height;
    has_size_ = true;
  }
  if (frame.depth.width != view_.width || frame.depth.height != view_.height) {
    Fail(folder_ / name,
         fmt::format("is of {}, the frames before of {}",
                     SizeText(frame.depth.width, frame.depth.height),
                     SizeText(view_.width, view_.height)));
  }
  frame.view = view_;
  frame.depth_unit = depth_unit_;
  return frame;
}

RgbdFrame RecordedFrames::Load(const std::string& name) const {
  RgbdFrame frame;
  const fs::path cloud = folder_ / (name + kCloud);
  if (fs::exists(cloud)) {
    PcdImage image = ReadPcd(cloud, depth_unit_);
    frame.colour = std::move(image.colour);
    frame.depth = std::move(image.depth);
    return frame;
  }
  const fs::path path = folder_ / (name + kDepth);
  frame.colour = ReadColourPng(folder_ / (name + kColour));
  frame.depth = ReadDepthPng(path);
  if (frame.depth.width != frame.colour.width ||
      frame.depth.height != frame.colour.height) {
    Fail(path, fmt::format("is of {}, its colour of {}",
                           SizeText(frame.depth.width, frame.depth.height),
                           SizeText(frame.colour.width, frame.colour.height)));
  }
  return frame;
}

}  // namespace cell
