#pragma once

#include <cstdint>
#include <string_view>

namespace cell {

/// A number that tells texts apart (FNV-1a), the same on every platform. Not
/// made against forgery.
constexpr uint64_t Fingerprint(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return hash;
}

}  // namespace cell
