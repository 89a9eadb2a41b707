#include "common/text/printable.h"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

namespace cell {
namespace {

struct CodePoint {
  uint32_t value = 0;
  size_t size = 0;  // [bytes]; 0: not UTF-8
};

bool IsContinuation(char c) {
  return (static_cast<uint8_t>(c) & 0xC0) == 0x80;
}

// The first code point of `text`, which is not empty (RFC 3629: no overlong
// forms, no surrogates, nothing above U+10FFFF).
CodePoint FirstOf(std::string_view text) {
  const auto lead = static_cast<uint8_t>(text[0]);
  if (lead < 0x80) return {lead, 1};
  const size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
  uint32_t value = lead & (0x7Fu >> size);
  for (size_t i = 1; i < size; ++i) {
    if (!IsContinuation(text[i])) return {};
    value = value << 6 | (static_cast<uint8_t>(text[i]) & 0x3Fu);
  }
  constexpr uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_valid = value >= kLeast[size] && value <= 0x10FFFF &&
                        (value < 0xD800 || value > 0xDFFF);
  return is_valid ? CodePoint{value, size} : CodePoint{};
}

bool IsIn(uint32_t value, uint32_t first, uint32_t last) {
  return value >= first && value <= last;
}

// True if a terminal would obey it, or show nothing, or reorder its line.
bool IsControl(uint32_t value) {
  return value < 0x20 || IsIn(value, 0x7F, 0x9F) || value == 0xAD ||
         value == 0x61C || IsIn(value, 0x200B, 0x200F) ||
         IsIn(value, 0x2028, 0x202E) || IsIn(value, 0x2060, 0x206F) ||
         value == 0xFEFF || IsIn(value, 0xFFF9, 0xFFFB) ||
         IsIn(value, 0xE0000, 0xE007F);
}

void AppendEscaped(uint32_t value, std::string* out) {
  switch (value) {
    case '\n':
      *out += "\\n";
      return;
    case '\r':
      *out += "\\r";
      return;
    case '\t':
      *out += "\\t";
      return;
    default:
      *out += value < 0x80      ? fmt::format("\\x{:02x}", value)
              : value < 0x10000 ? fmt::format("\\u{:04x}", value)
                                : fmt::format("\\U{:08x}", value);
  }
}

std::string Escaped(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const CodePoint point = FirstOf(text);
    if (point.size == 0) {
      fmt::format_to(std::back_inserter(out), "\\x{:02x}",
                     static_cast<uint8_t>(text[0]));
      text.remove_prefix(1);
      continue;
    }
    if (IsControl(point.value) &&
        kept.find(text[0]) == std::string_view::npos) {
      AppendEscaped(point.value, &out);
    } else {
      out += text.substr(0, point.size);
    }
    text.remove_prefix(point.size);
  }
  return out;
}

}  // namespace

std::string Printable(std::string_view text) {
  return Escaped(text, "");
}

std::string PrintableLines(std::string_view text) {
  return Escaped(text, "\n\t");
}

std::string PrintableName(std::string_view text, size_t max_columns) {
  // Four bytes at most become a code point; so no long name is worked through.
  std::string name = Printable(text.substr(0, 4 * max_columns + 4));
  size_t num_columns = 0;
  size_t cut = 0;
  for (size_t i = 0; i < name.size(); ++i) {
    if (IsContinuation(name[i])) continue;
    if (num_columns + 1 == max_columns) cut = i;
    if (++num_columns > max_columns) return name.substr(0, cut) + "~";
  }
  return name;
}

}  // namespace cell
