#pragma once

#include <cstdint>
#include <string>

namespace cell {

/// "1 step", "2 steps". @param plural  empty: the noun with an s
std::string Counted(int64_t number, const std::string& noun,
                    const std::string& plural = "");

}  // namespace cell
