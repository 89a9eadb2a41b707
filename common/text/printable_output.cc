#include "common/text/printable_output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include "common/text/printable.h"

namespace cell {

bool PrintableBuffer::Forward(size_t size) {
  const std::string text =
      PrintableLines(std::string_view(pending_).substr(0, size));
  pending_.erase(0, size);
  const auto length = static_cast<std::streamsize>(text.size());
  return target_->sputn(text.data(), length) == length;
}

std::streamsize PrintableBuffer::xsputn(const char* text,
                                        std::streamsize size) {
  pending_.append(text, static_cast<size_t>(size));
  // A character that is written in parts must not be cut; a line is whole.
  const size_t end = pending_.rfind('\n');
  if (end != std::string::npos && !Forward(end + 1)) return 0;
  return size;
}

PrintableBuffer::int_type PrintableBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return 0;
  const char character = traits_type::to_char_type(c);
  return xsputn(&character, 1) == 1 ? c : traits_type::eof();
}

int PrintableBuffer::sync() {
  const bool is_passed = Forward(pending_.size());
  return target_->pubsync() == 0 && is_passed ? 0 : -1;
}

PrintableOutput::PrintableOutput()
    : out_(std::cout.rdbuf()), error_(std::cerr.rdbuf()) {
  std::cout.rdbuf(&out_);
  std::cerr.rdbuf(&error_);
}

PrintableOutput::~PrintableOutput() {
  std::cout.flush();
  std::cerr.flush();
  std::cout.rdbuf(out_.target());
  std::cerr.rdbuf(error_.target());
}

int PrintableOutput::Finish(int code) {
  if (std::cout.flush() && std::fflush(stdout) == 0) return code;
  // Once more, for the reason.
  errno = 0;
  std::fputc('\n', stdout);
  std::fflush(stdout);
  std::cerr << "standard output cannot be written"
            << (errno != 0 ? std::string(": ") + std::strerror(errno) : "")
            << std::endl;
  return code != 0 ? code : 1;
}

void WriteTerminalCode(std::ostream& stream, const std::string& code) {
  stream.flush();
  if (const auto* buffer = dynamic_cast<PrintableBuffer*>(stream.rdbuf())) {
    buffer->target()->sputn(code.data(),
                            static_cast<std::streamsize>(code.size()));
    return;
  }
  stream << code;
}

}  // namespace cell
