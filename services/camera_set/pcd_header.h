#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cell::camera_set {

/// What a PCD file says of itself.
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

/// Reads the header and holds every claim of it against the file: PCL's reader
/// makes room for what a header announces before it can be asked, and reads on
/// where a value is none.
/// @throws std::runtime_error naming the file, and what would be right, unless
/// it is an organised cloud of at most kMaxPixels points with x, y, z (F 4) and
/// colour (rgb or rgba, 4 bytes), whose data is all there and nothing else.
PcdHeader CheckPcd(const std::filesystem::path& path);

}  // namespace cell::camera_set
