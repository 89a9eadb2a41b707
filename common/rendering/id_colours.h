#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cell {

/// `num` colours that look as different as possible from each other and from
/// black: each is the one that is furthest from all before it (CIE 1976 L*a*b*,
/// of sRGB). The first ones are the same for any number.
std::vector<std::array<uint8_t, 3>> DistinctColours(size_t num);

/// How different two colours look: their distance in L*a*b*. Of 2 a person
/// sees that they differ, of 10 at a glance.
double ColourDifference(const std::array<uint8_t, 3>& a,
                        const std::array<uint8_t, 3>& b);

}  // namespace cell
