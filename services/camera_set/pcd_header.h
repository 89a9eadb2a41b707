#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cell::camera_set {

/// The header of a PCD file.
struct PcdHeader {
  enum class Data { kAscii, kBinary, kCompressed };
  struct Field {
    std::string name;
    int size = 0;       ///< [bytes] of a value: 1, 2, 4, 8
    char type = 0;      ///< F, I, U
    int64_t count = 1;  ///< values
  };
  std::vector<Field> fields;
  int64_t width = 0;
  int64_t height = 0;
  Data data = Data::kAscii;
  int64_t data_begin = 0;  ///< [bytes] from the begin of the file
  int64_t num_lines = 0;   ///< of the header

  int64_t num_points() const { return width * height; }
  int64_t PointSize() const;  ///< [bytes]
};

/// Reads the header and checks every entry against the file: PCL's reader
/// allocates what a header announces without a check, and skips values that are
/// no numbers.
/// @throws std::runtime_error naming the file, and what would be right, unless
/// it is an organised cloud of at most kMaxPixels points with x, y, z (F 4) and
/// colour (rgb or rgba, 4 bytes), with complete data and nothing else.
PcdHeader CheckPcd(const std::filesystem::path& path);

}  // namespace cell::camera_set
