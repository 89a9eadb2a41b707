#include "services/camera_set/recorded_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "common/config/config.h"
#include "common/imaging/png_file.h"
#include "services/camera_set/file_error.h"
#include "services/camera_set/pcd_file.h"

namespace cell::camera_set {
namespace {

namespace fs = std::filesystem;

constexpr char kColour[] = ".colour.png";
constexpr char kDepth[] = ".depth.png";
constexpr char kCloud[] = ".pcd";

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

/// A key that orders names by the values of their numbers (2 before 10): each
/// number is preceded by its length.
std::string OrderKey(const std::string& name) {
  std::string key;
  for (size_t i = 0; i < name.size();) {
    size_t end = i;
    while (end < name.size() && IsDigit(name[end])) ++end;
    if (end == i) {
      key += name[i++];
      continue;
    }
    size_t begin = i;
    while (begin + 1 < end && name[begin] == '0') ++begin;
    key +=
        fmt::format("0{:03}{}", end - begin, name.substr(begin, end - begin));
    i = end;
  }
  return key;
}

bool IsBefore(const std::string& a, const std::string& b) {
  const std::string key_a = OrderKey(a);
  const std::string key_b = OrderKey(b);
  return key_a != key_b ? key_a < key_b : a < b;
}

std::string SizeText(int width, int height) {
  return fmt::format("{} x {} pixels", width, height);
}

bool IsWithoutDepth(const DepthImage& depth) {
  return std::all_of(depth.counts.begin(), depth.counts.end(),
                     [](uint16_t count) { return count == 0; });
}

}  // namespace

RecordedFrames::RecordedFrames(fs::path folder, bool is_loop)
    : folder_(std::move(folder)), is_loop_(is_loop) {
  if (!fs::is_directory(folder_))
    FailFile(folder_, "is not a folder of frames");
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
  if (names.empty()) FailFile(folder_, "holds no frame");
  names_.assign(names.begin(), names.end());
  std::sort(names_.begin(), names_.end(), IsBefore);
  for (const std::string& name : names_) {
    const fs::path cloud = folder_ / (name + kCloud);
    if (fs::exists(cloud)) {
      if (fs::exists(folder_ / (name + kColour)) ||
          fs::exists(folder_ / (name + kDepth))) {
        FailFile(cloud,
                 "the same frame also exists as a picture; remove one of them");
      }
      continue;
    }
    for (const char* half : {kColour, kDepth}) {
      const fs::path path = folder_ / (name + half);
      if (!fs::exists(path))
        FailFile(path, "is missing; the other picture of its frame exists");
    }
  }
}

std::optional<RgbdFrame> RecordedFrames::Next() {
  if (next_ == names_.size()) {
    if (!is_loop_) return std::nullopt;
    next_ = 0;
  }
  const std::string& name = names_[next_++];
  remark_.clear();
  RgbdFrame frame = Load(name);
  if (IsWithoutDepth(frame.depth)) {
    remark_ = fmt::format("{}: none of its {} pixels was measured",
                          (folder_ / name).string(), frame.depth.counts.size());
  }
  if (!remark_.empty() && !remarked_.insert(name).second) remark_.clear();
  if (!has_size_) {
    view_.width = frame.depth.width;
    view_.height = frame.depth.height;
    has_size_ = true;
  }
  if (frame.depth.width != view_.width || frame.depth.height != view_.height) {
    FailFile(folder_ / name,
             fmt::format("has {}, the frames before it {}",
                         SizeText(frame.depth.width, frame.depth.height),
                         SizeText(view_.width, view_.height)));
  }
  frame.view = view_;
  frame.depth_unit = depth_unit_;
  return frame;
}

RgbdFrame RecordedFrames::LoadCloud(const fs::path& path) {
  PcdImage image = ReadPcd(path, depth_unit_);
  const PcdImage::Lost& lost = image.lost;
  if (lost.num_beyond + lost.num_behind > 0) {
    remark_ = fmt::format(
        "{}: of {} points {} lie beyond {} m and {} not in front of the "
        "camera; they are ignored",
        path.string(), image.depth.counts.size(), lost.num_beyond, lost.range,
        lost.num_behind);
  }
  RgbdFrame frame;
  frame.colour = std::move(image.colour);
  frame.depth = std::move(image.depth);
  return frame;
}

RgbdFrame RecordedFrames::Load(const std::string& name) {
  RgbdFrame frame;
  const fs::path cloud = folder_ / (name + kCloud);
  if (fs::exists(cloud)) return LoadCloud(cloud);
  const fs::path path = folder_ / (name + kDepth);
  frame.colour = ReadColourPng(folder_ / (name + kColour));
  frame.depth = ReadDepthPng(path);
  if (frame.depth.width != frame.colour.width ||
      frame.depth.height != frame.colour.height) {
    FailFile(path,
             fmt::format("has {}, its colour {}",
                         SizeText(frame.depth.width, frame.depth.height),
                         SizeText(frame.colour.width, frame.colour.height)));
  }
  return frame;
}

}  // namespace cell::camera_set
