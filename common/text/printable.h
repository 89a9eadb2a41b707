#pragma once

#include <string>
#include <string_view>

namespace cell {

/// `text` as one line that a terminal shows as it is and obeys in nothing. What
/// comes from a log, the bus or another process must pass through here before
/// it is printed. Control characters (C0, DEL, C1), line and paragraph
/// separators, invisible and bidirectional controls, and bytes that are not
/// UTF-8 are written out: "\n", "\x1b", "\u202e". The rest stays, so that to
/// do it twice changes nothing.
std::string Printable(std::string_view text);

/// The same of text that we have laid out: its '\n' and '\t' stay.
std::string PrintableLines(std::string_view text);

/// Printable(text), at most `max_columns` code points; the last one is "~" if
/// some are left out.
std::string PrintableName(std::string_view text, size_t max_columns);

}  // namespace cell
