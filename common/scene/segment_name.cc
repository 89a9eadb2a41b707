#include "common/scene/segment_name.h"

#include <algorithm>
#include <string_view>

namespace cell {
namespace {

constexpr std::string_view kPrefix = "segment ";
constexpr size_t kMaxLength = 40;

bool IsId(std::string_view id) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9') ||
           std::string_view("_.@+-").find(c) != std::string_view::npos;
  };
  return !id.empty() && id.size() <= kMaxLength &&
         std::ranges::all_of(id, is_allowed);
}

}  // namespace

std::optional<std::string> SegmentName(const std::string& id) {
  if (IsSegmentName(id)) return id;
  if (!IsId(id)) return std::nullopt;
  return std::string(kPrefix) + id;
}

bool IsSegmentName(const std::string& name) {
  return name.starts_with(kPrefix) &&
         IsId(std::string_view(name).substr(kPrefix.size()));
}

}  // namespace cell
