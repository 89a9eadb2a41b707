#include "services/camera_set/pcd_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "common/config/decimal.h"
#include "common/imaging/depth_image.h"
#include "services/camera_set/file_error.h"

namespace cell::camera_set {
namespace {

using Field = PcdHeader::Field;
using Data = PcdHeader::Data;
using Words = std::vector<std::string>;

constexpr int64_t kMaxHeaderLines = 100;
constexpr size_t kMaxFields = 64;
constexpr int64_t kMaxPointSize = 4096;  // [bytes]

Words WordsOf(const std::string& line) {
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The header's entries, each at most once, and where the data begins.
class Entries {
 public:
  Entries(const std::filesystem::path& path, std::istream& file) : path_(path) {
    for (std::string line; std::getline(file, line);) {
      if (++num_lines_ > kMaxHeaderLines) break;
      Words words = WordsOf(line);
      if (words.empty() || words[0].starts_with('#')) continue;
      const std::string key = words[0];
      words.erase(words.begin());
      if (!words_.emplace(key, words).second) {
        FailFile(path, fmt::format("{} is in its header twice", key));
      }
      if (key == "DATA") return;
    }
    FailFile(path, "is not a PCD file: no DATA line ends its header");
  }

  int64_t num_lines() const { return num_lines_; }
  bool Has(const std::string& key) const { return words_.contains(key); }
  const Words& operator[](const std::string& key) const {
    const auto it = words_.find(key);
    if (it == words_.end()) FailFile(path_, "lacks the line " + key);
    return it->second;
  }
  int64_t Number(const std::string& key, const std::string& word) const {
    const Result<int64_t> number = ParseDecimal<int64_t>(word);
    if (number && *number >= 0) return *number;
    FailFile(path_, fmt::format("{} '{}' {}", key, word,
                                number ? "is negative" : number.reason()));
  }
  int64_t Number(const std::string& key) const {
    const Words& words = (*this)[key];
    if (words.size() != 1) FailFile(path_, key + " should be one number");
    return Number(key, words[0]);
  }

 private:
  std::filesystem::path path_;
  std::map<std::string, Words> words_;
  int64_t num_lines_ = 0;
};

bool IsOneOf(const std::string& text, std::initializer_list<const char*> all) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

std::vector<Field> FieldsOf(const std::filesystem::path& path,
                            const Entries& entries) {
  const Words& names = entries["FIELDS"];
  const Words& sizes = entries["SIZE"];
  const Words& types = entries["TYPE"];
  const Words counts =
      entries.Has("COUNT") ? entries["COUNT"] : Words(names.size(), "1");
  if (names.size() != sizes.size() || names.size() != types.size() ||
      names.size() != counts.size() || names.size() > kMaxFields) {
    FailFile(path,
             fmt::format("has {} FIELDS, {} SIZEs, {} TYPEs, {} COUNTs; all "
                         "should be as many, at most {}",
                         names.size(), sizes.size(), types.size(),
                         counts.size(), kMaxFields));
  }
  std::vector<Field> fields;
  for (size_t i = 0; i < names.size(); ++i) {
    const bool is_known = types[i] == "F"
                              ? IsOneOf(sizes[i], {"4", "8"})
                              : IsOneOf(types[i], {"I", "U"}) &&
                                    IsOneOf(sizes[i], {"1", "2", "4", "8"});
    if (!is_known) {
      FailFile(path, fmt::format(
                         "{}: TYPE {} of SIZE {} is not one of F 4 8, I and U "
                         "1 2 4 8",
                         names[i], types[i], sizes[i]));
    }
    fields.push_back({names[i], sizes[i][0] - '0', types[i][0],
                      entries.Number("COUNT", counts[i])});
    if (fields.back().count < 1 || fields.back().count > kMaxPointSize) {
      FailFile(path, fmt::format("{}: COUNT {} is outside [1, {}]", names[i],
                                 counts[i], kMaxPointSize));
    }
  }
  return fields;
}

void CheckFields(const std::filesystem::path& path, const PcdHeader& header) {
  std::map<std::string, const Field*> known;
  for (const Field& field : header.fields) {
    if (!known.emplace(field.name, &field).second && field.name != "_") {
      FailFile(path, "has the field " + field.name + " twice");
    }
  }
  for (const char* name : {"x", "y", "z"}) {
    if (!known.contains(name)) FailFile(path, fmt::format("lacks {}", name));
    const Field& field = *known.at(name);
    if (field.type != 'F' || field.size != 4 || field.count != 1) {
      FailFile(path,
               fmt::format("{} is of TYPE {}, SIZE {}, COUNT {}; F, 4, 1 is "
                           "read",
                           name, field.type, field.size, field.count));
    }
  }
  if (!known.contains("rgb") && !known.contains("rgba")) {
    FailFile(path, "lacks colour: rgb or rgba");
  }
  const Field& colour = *known.at(known.contains("rgb") ? "rgb" : "rgba");
  if (colour.size != 4 || colour.count != 1) {
    FailFile(path, fmt::format("{} is of SIZE {}, COUNT {}; 4, 1 is read",
                               colour.name, colour.size, colour.count));
  }
  if (header.PointSize() > kMaxPointSize) {
    FailFile(path, fmt::format("a point has {} bytes; at most {} are read",
                               header.PointSize(), kMaxPointSize));
  }
}

void ReadSize(const std::filesystem::path& path, const Entries& entries,
              PcdHeader& header) {
  header.width = entries.Number("WIDTH");
  header.height = entries.Number("HEIGHT");
  const int64_t num_points = entries.Number("POINTS");
  if (header.height <= 1 || !IsPictureSize(header.width, header.height) ||
      num_points != header.num_points()) {
    FailFile(path,
             fmt::format("is not an organised cloud of at most {} points: "
                         "{} x {}, {} in all",
                         kMaxPixels, header.width, header.height, num_points));
  }
}

Data DataOf(const std::filesystem::path& path, const Words& words) {
  if (words.size() == 1 && words[0] == "ascii") return Data::kAscii;
  if (words.size() == 1 && words[0] == "binary") return Data::kBinary;
  if (words.size() == 1 && words[0] == "binary_compressed") {
    return Data::kCompressed;
  }
  FailFile(path, fmt::format("DATA '{}' is not one of ascii, binary, "
                             "binary_compressed",
                             words.empty() ? "" : words[0]));
}

/// Refuses bytes behind the data unless they only fill up a page.
void CheckEnd(const std::filesystem::path& path, std::istream& file,
              int64_t begin, int64_t num_there, int64_t num_claimed) {
  if (num_there < num_claimed) {
    FailFile(path,
             fmt::format("is cut off: its header claims {} bytes of points, "
                         "{} are present",
                         num_claimed, num_there));
  }
  file.clear();
  file.seekg(begin + num_claimed);
  for (char byte = 0; file.get(byte);) {
    if (byte == 0) continue;
    FailFile(path, fmt::format("has {} bytes after its points",
                               num_there - num_claimed));
  }
}

void CheckBinary(const std::filesystem::path& path, std::istream& file,
                 const PcdHeader& header, int64_t num_bytes) {
  const int64_t num_points = header.num_points() * header.PointSize();
  int64_t begin = header.data_begin;
  int64_t claimed = num_points;
  if (header.data == Data::kCompressed) {
    std::array<uint32_t, 2> sizes{};  // compressed, not compressed
    file.read(reinterpret_cast<char*>(sizes.data()), sizeof sizes);
    if (!file) FailFile(path, "is cut off where its points begin");
    if (sizes[1] != num_points) {
      FailFile(path,
               fmt::format("claims {} bytes of points; its header implies {}",
                           sizes[1], num_points));
    }
    begin += static_cast<int64_t>(sizeof sizes);
    claimed = sizes[0];
  }
  CheckEnd(path, file, begin, num_bytes - begin, claimed);
}

bool IsValueOf(const Field& field, const std::string& word) {
  if (field.type == 'F') {
    const std::string digits =
        word.substr(word.starts_with('-') || word.starts_with('+') ? 1 : 0);
    if (IsOneOf(digits, {"nan", "NaN", "NAN", "inf", "Inf", "INF"}))
      return true;
    return bool(ParseDecimal<double>(word));
  }
  const auto value = ParseDecimal<int64_t>(word);
  if (!value) return field.size == 8 && ParseDecimal<uint64_t>(word);
  const int num_bits = 8 * field.size - (field.type == 'I' ? 1 : 0);
  if (num_bits >= 63) return field.type == 'I' || *value >= 0;
  const int64_t end = int64_t{1} << num_bits;
  return *value < end && *value >= (field.type == 'I' ? -end : 0);
}

void CheckLine(const std::filesystem::path& path, int64_t number,
               const Words& words, const PcdHeader& header) {
  size_t i = 0;
  for (const Field& field : header.fields) {
    for (int64_t k = 0; k < field.count; ++k, ++i) {
      if (i >= words.size()) {
        FailFile(path,
                 fmt::format("line {}: ends before {}", number, field.name));
      }
      if (!IsValueOf(field, words[i])) {
        FailFile(
            path,
            fmt::format("line {}: {} cannot be '{}'; a number of TYPE "
                        "{}, SIZE {} with a decimal point is read",
                        number, field.name, words[i], field.type, field.size));
      }
    }
  }
  if (i != words.size()) {
    FailFile(path, fmt::format("line {}: has {} values, its header implies {}",
                               number, words.size(), i));
  }
}

void CheckAscii(const std::filesystem::path& path, std::istream& file,
                const PcdHeader& header) {
  int64_t number = header.num_lines;
  int64_t num_points = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    const Words words = WordsOf(line);
    if (words.empty()) continue;
    CheckLine(path, number, words, header);
    ++num_points;
  }
  if (num_points != header.num_points()) {
    FailFile(path, fmt::format("has {} points, its header claims {}",
                               num_points, header.num_points()));
  }
}

}  // namespace

int64_t PcdHeader::PointSize() const {
  int64_t size = 0;
  for (const Field& field : fields) size += field.size * field.count;
  return size;
}

PcdHeader CheckPcd(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) FailFile(path, "cannot be opened");
  std::error_code error;
  const auto num_bytes = std::filesystem::file_size(path, error);
  if (error) FailFile(path, "is not a file");
  const Entries entries(path, file);
  PcdHeader header;
  header.data_begin = file.tellg();
  header.num_lines = entries.num_lines();
  header.fields = FieldsOf(path, entries);
  ReadSize(path, entries, header);
  CheckFields(path, header);
  header.data = DataOf(path, entries["DATA"]);
  if (header.data == Data::kAscii) {
    CheckAscii(path, file, header);
  } else {
    CheckBinary(path, file, header, static_cast<int64_t>(num_bytes));
  }
  return header;
}

}  // namespace cell::camera_set
