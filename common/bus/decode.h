#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "common/bus/message.h"

namespace cell {

/// Times of a run lie in [0, kMaxUtime]: sums and differences of what has
/// been measured fit an int64_t. (A deadline is only compared.)
inline constexpr int64_t kMaxUtime = int64_t{1} << 61;

constexpr bool IsUtime(int64_t utime) {
  return utime >= 0 && utime <= kMaxUtime;
}

/// The message of type M, or nothing if the bytes are not exactly one, or its
/// utime is not within [0, kMaxUtime].
template <class M>
std::optional<M> Decode(std::span<const uint8_t> bytes) {
  std::optional<M> decoded(std::in_place);
  const int size = static_cast<int>(bytes.size());
  bool is_sound = decoded->decode(bytes.data(), 0, size) == size;
  if constexpr (requires { decoded->header.utime; }) {
    is_sound = is_sound && IsUtime(decoded->header.utime);
  }
  if constexpr (requires { decoded->pick_utime; }) {
    is_sound = is_sound && IsUtime(decoded->pick_utime);
  }
  if (!is_sound) decoded.reset();
  return decoded;
}

template <class M>
std::optional<M> Decode(const Message& message) {
  return Decode<M>(std::span(*message.bytes));
}

}  // namespace cell
