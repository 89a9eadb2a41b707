#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace cell {

/// Forwards PrintableLines() of what is written to another buffer, and reports
/// every failure of that one. Keeps back at most one incomplete line.
class PrintableBuffer : public std::streambuf {
 public:
  /// `target` must outlive it.
  explicit PrintableBuffer(std::streambuf* target) : target_(target) {}
  std::streambuf* target() const { return target_; }

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  bool Forward(size_t size);

  std::streambuf* target_;
  std::string pending_;
};

/// While it exists, std::cout and std::cerr go through a PrintableBuffer each:
/// no text that a program prints, wherever it came from, commands a terminal.
/// Code that lays out lines of foreign text still calls Printable(), since a
/// line feed passes here. For main() alone.
class PrintableOutput {
 public:
  PrintableOutput();
  ~PrintableOutput();
  PrintableOutput(const PrintableOutput&) = delete;
  PrintableOutput& operator=(const PrintableOutput&) = delete;

  /// The exit code of a program that has otherwise ended with `code`: 1 instead
  /// of 0, with the reason on std::cerr, if what went to std::cout has not all
  /// been written, to a full disk say.
  int Finish(int code);

 private:
  PrintableBuffer out_;
  PrintableBuffer error_;
};

/// Writes a terminal's own control code, which passes a PrintableBuffer.
void WriteTerminalCode(std::ostream& stream, const std::string& code);

}  // namespace cell
