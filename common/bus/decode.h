#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "common/bus/message.h"

namespace cell {

/// The message of type M, or nothing if the bytes are not one, whole.
template <class M>
std::optional<M> Decode(std::span<const uint8_t> bytes) {
  std::optional<M> decoded(std::in_place);
  const int size = static_cast<int>(bytes.size());
  if (decoded->decode(bytes.data(), 0, size) != size) decoded.reset();
  return decoded;
}

template <class M>
std::optional<M> Decode(const Message& message) {
  return Decode<M>(std::span(*message.bytes));
}

}  // namespace cell
