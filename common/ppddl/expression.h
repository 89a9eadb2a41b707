#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/ppddl/ppddl_error.h"

namespace cell::ppddl {

/// A word or a list in parentheses, with its place in the text. Words are in
/// lower case, since PPDDL does not tell cases apart.
struct Expression {
  bool is_list = false;
  std::string word;               ///< of a word
  std::vector<Expression> items;  ///< of a list
  int line = 0;                   ///< from 1
  int column = 0;                 ///< from 1, in bytes
  std::shared_ptr<const std::string> file;

  bool Is(std::string_view text) const { return !is_list && word == text; }
  /// True for a list whose first item is this word.
  bool BeginsWith(std::string_view text) const {
    return is_list && !items.empty() && items.front().Is(text);
  }
  /// The first word of a list, or the word itself; empty if there is none.
  const std::string& Head() const;

  /// @throws PpddlError "file:line:column: message"
  [[noreturn]] void Fail(const std::string& message) const;
};

/// All expressions of a text. Comments run from `;` to the end of the line.
/// @param file  names the text in errors
/// @throws PpddlError for unbalanced parentheses, bytes that no name may have,
/// and lists nested deeper than 200.
std::vector<Expression> ReadExpressions(std::string_view text,
                                        const std::string& file);

}  // namespace cell::ppddl
