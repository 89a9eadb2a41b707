#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cell::rules {

/// A place in a text, for errors.
struct Place {
  std::string file;
  int line = 0;
  /// @throws RuleError
  [[noreturn]] void Fail(const std::string& message) const;
};

/// The lines of a text, the first one numbered `first`; with '#' a comment
/// begins. Lines with nothing else are empty.
struct TextLine {
  Place place;
  std::string text;
};
std::vector<TextLine> SplitLines(const std::string& text,
                                 const std::string& file, int first = 1);

/// Splits a line into words (letters, digits, '_', '.', '-' inside) and signs
/// of one or two characters: ( ) , : ; = < > <= >= != + - <--
class TokenReader {
 public:
  TokenReader(std::string_view text, Place place);

  bool AtEnd() const { return next_ == tokens_.size(); }
  /// Empty at the end.
  const std::string& Peek(size_t ahead = 0) const;
  std::string Next();
  bool TakeIf(std::string_view token);
  /// @throws RuleError unless the next token is `token`.
  void Expect(std::string_view token);
  /// @param what  for the error: "an object"
  std::string Word(std::string_view what);
  int Integer(std::string_view what);
  [[noreturn]] void Fail(const std::string& message) const {
    place_.Fail(message);
  }
  const Place& place() const { return place_; }

 private:
  Place place_;
  std::vector<std::string> tokens_;
  size_t next_ = 0;
};

bool IsWord(std::string_view token);
/// Variables begin with a capital letter, objects do not.
bool IsVariableName(std::string_view token);

}  // namespace cell::rules
