#pragma once

#include <cstddef>
#include <cstdint>

namespace cell {

/// The first four bytes, in network order, of LCM's UDP packets: "LC02" for a
/// short message, "LC03" for a fragment of a long one.
inline constexpr uint32_t kShortMagic = 0x4c433032;
inline constexpr uint32_t kFragmentMagic = 0x4c433033;

/// What precedes the channel's name: magic and sequence number; of a fragment
/// also the message's size, the fragment's offset, its number and how many
/// there are.
inline constexpr size_t kShortHeaderSize = 8;
inline constexpr size_t kFragmentHeaderSize = 20;

}  // namespace cell
