#include "common/rules/tokens.h"

#include <cctype>
#include <charconv>
#include <sstream>

#include "common/rules/rule_error.h"
#include "common/text/byte_order_mark.h"
#include "common/text/printable.h"

namespace cell::rules {
namespace {

bool IsWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
}

/// Characters of the token at the front of `text`.
size_t TokenLength(std::string_view text) {
  size_t length = 0;
  while (length < text.size() &&
         (IsWordCharacter(text[length]) ||
          // a hyphen inside a word: pick-up
          (length > 0 && text[length] == '-' && length + 1 < text.size() &&
           std::isalpha(static_cast<unsigned char>(text[length + 1]))))) {
    ++length;
  }
  if (length > 0) return length;
  for (const char* sign : {"<--", "<=", ">=", "!="}) {
    if (text.starts_with(sign)) return std::string_view(sign).size();
  }
  return 1;
}

}  // namespace

void Place::Fail(const std::string& message) const {
  throw RuleError(file, line, message);
}

std::vector<TextLine> SplitLines(const std::string& text,
                                 const std::string& file, int first) {
  std::vector<TextLine> lines;
  std::istringstream stream{std::string(WithoutByteOrderMark(text))};
  std::string line;
  for (int number = first; std::getline(stream, line); ++number) {
    line = line.substr(0, line.find('#'));
    const size_t end = line.find_last_not_of(" \t\r");
    lines.push_back({{file, number}, line.substr(0, end + 1)});
  }
  return lines;
}

bool IsWord(std::string_view token) {
  return !token.empty() && IsWordCharacter(token[0]);
}

bool IsVariableName(std::string_view token) {
  return !token.empty() && std::isupper(static_cast<unsigned char>(token[0]));
}

TokenReader::TokenReader(std::string_view text, Place place)
    : place_(std::move(place)) {
  while (!text.empty()) {
    if (text[0] == ' ' || text[0] == '\t') {
      text.remove_prefix(1);
      continue;
    }
    const size_t length = TokenLength(text);
    tokens_.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
}

const std::string& TokenReader::Peek(size_t ahead) const {
  static const std::string kNone;
  return next_ + ahead < tokens_.size() ? tokens_[next_ + ahead] : kNone;
}

std::string TokenReader::Next() {
  return AtEnd() ? "" : tokens_[next_++];
}

bool TokenReader::TakeIf(std::string_view token) {
  if (AtEnd() || tokens_[next_] != token) return false;
  ++next_;
  return true;
}

void TokenReader::Expect(std::string_view token) {
  if (TakeIf(token)) return;
  Fail(fmt::format(
      "expected '{}', not {}", token,
      AtEnd() ? "the end of the line" : "'" + Printable(Peek()) + "'"));
}

std::string TokenReader::Word(std::string_view what) {
  if (IsWord(Peek())) return Next();
  Fail(fmt::format(
      "expected {}, not {}", what,
      AtEnd() ? "the end of the line" : "'" + Printable(Peek()) + "'"));
}

int TokenReader::Integer(std::string_view what) {
  const std::string sign = TakeIf("-") ? "-" : "";
  const std::string word = sign + Word(what);
  int value = 0;
  const auto [end, error] =
      std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    Fail(fmt::format("expected {}, not '{}'", what, word));
  }
  return value;
}

}  // namespace cell::rules
