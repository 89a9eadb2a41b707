// Text of unknown origin on a terminal.
#include "common/text/printable.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "common/text/printable_output.h"

namespace cell {
namespace {

TEST(Printable, LeavesTextOfAnyLanguageAsItIs) {
  const std::string text = "Käfig_1 ölçüm 部品 🦾 \\x1b ~";
  EXPECT_EQ(Printable(text), text);
}

TEST(Printable, WritesOutWhatATerminalObeys) {
  EXPECT_EQ(Printable("\x1b[2J"), "\\x1b[2J");
  EXPECT_EQ(Printable("a\n0 findings\r\t"), "a\\n0 findings\\r\\t");
  EXPECT_EQ(Printable(std::string("a\0b\x7f", 4)), "a\\x00b\\x7f");
}

TEST(Printable, WritesOutEightBitControls) {
  EXPECT_EQ(Printable("\xc2\x9b"
                      "2J"),
            "\\u009b2J");
  EXPECT_EQ(Printable("\x9b"
                      "2J"),
            "\\x9b2J");
}

TEST(Printable, WritesOutWhatReordersOrHidesText) {
  EXPECT_EQ(Printable("a\u202Eb\u2066c\u2069\u061C"),
            "a\\u202eb\\u2066c\\u2069\\u061c");
  EXPECT_EQ(Printable("TICK\u200B \uFEFF\u2028"), "TICK\\u200b \\ufeff\\u2028");
  EXPECT_EQ(Printable("\U000E0041"), "\\U000e0041");
}

TEST(Printable, WritesOutBytesThatAreNotUtf8) {
  EXPECT_EQ(Printable("\xc3"), "\\xc3");                    // cut
  EXPECT_EQ(Printable("\xc0\x8a"), "\\xc0\\x8a");           // overlong
  EXPECT_EQ(Printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // surrogate
  EXPECT_EQ(Printable("\xf5\x80\x80\x80"), "\\xf5\\x80\\x80\\x80");
  EXPECT_EQ(Printable("\xff"), "\\xff");
}

TEST(Printable, OfAnyBytesIsOneLineAndItsOwnPrintableText) {
  std::mt19937 random(13);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (int k = 0; k < 40; ++k) text += static_cast<char>(random());
    const std::string shown = Printable(text);
    for (const char c : shown) {
      ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << shown;
    }
    ASSERT_EQ(Printable(shown), shown);
  }
}

TEST(Printable, ANameIsCutToItsColumnsAndSaysSo) {
  EXPECT_EQ(PrintableName("KEY_FRAME", 9), "KEY_FRAME");
  EXPECT_EQ(PrintableName("KEY_FRAME", 8), "KEY_FRA~");
  EXPECT_EQ(PrintableName("ölçüm", 4), "ölç~");
  EXPECT_EQ(PrintableName("\x1b\x1b", 6), "\\x1b\\~");
  EXPECT_EQ(PrintableName(std::string(1 << 20, 'x'), 6), "xxxxx~");
}

TEST(PrintableBuffer, LetsLinesPassAndNoCommands) {
  std::ostringstream shown;
  PrintableBuffer buffer(shown.rdbuf());
  std::ostream stream(&buffer);
  stream << "a\x1b[2J\tb\n"
         << "\xc3"
         << "\xa4"
         << "\n";
  EXPECT_EQ(shown.str(), "a\\x1b[2J\tb\nä\n");
  stream << "half a line" << std::flush;
  EXPECT_EQ(shown.str(), "a\\x1b[2J\tb\nä\nhalf a line");
  WriteTerminalCode(stream, "\x1b[K");
  EXPECT_EQ(shown.str(), "a\\x1b[2J\tb\nä\nhalf a line\x1b[K");
}

TEST(PrintableBuffer, TellsThatItsTargetCannotBeWritten) {
  struct Full : std::streambuf {
  } full;
  PrintableBuffer buffer(&full);
  std::ostream stream(&buffer);
  stream << "text" << std::flush;
  EXPECT_FALSE(stream);
}

}  // namespace
}  // namespace cell
