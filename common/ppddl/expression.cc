#include "common/ppddl/expression.h"

#include <fmt/format.h>

#include <cctype>
#include <utility>

#include "common/text/byte_order_mark.h"
#include "common/text/printable.h"

namespace cell::ppddl {
namespace {

constexpr size_t kMaxDepth = 200;
constexpr size_t kMaxWord = 1000;

/// What a word may be made of besides letters and digits.
bool IsWordByte(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("-_?:=.+*/@#$%&!<>~^[]{}|',").find(c) !=
             std::string_view::npos;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file)
      : text_(WithoutByteOrderMark(text)),
        file_(std::make_shared<const std::string>(file)) {}

  std::vector<Expression> ReadAll() {
    while (SkipSpace()) ReadNext();
    if (!open_.empty()) {
      open_.back().Fail("this parenthesis is never closed");
    }
    return std::move(top_);
  }

 private:
  /// False at the end of the text.
  bool SkipSpace() {
    while (at_ < text_.size()) {
      if (text_[at_] == ';') {
        while (at_ < text_.size() && text_[at_] != '\n') Advance();
      } else if (std::isspace(static_cast<unsigned char>(text_[at_]))) {
        Advance();
      } else {
        return true;
      }
    }
    return false;
  }

  void Advance() {
    if (text_[at_++] == '\n') {
      ++line_;
      column_ = 1;
    } else {
      ++column_;
    }
  }

  Expression Here(bool is_list) const {
    return {is_list, {}, {}, line_, column_, file_};
  }

  void ReadNext() {
    if (text_[at_] == '(') {
      if (open_.size() == kMaxDepth) {
        Here(true).Fail(fmt::format(
            "lists are nested deeper than {}; flatten the formula", kMaxDepth));
      }
      open_.push_back(Here(true));
      Advance();
    } else if (text_[at_] == ')') {
      if (open_.empty()) Here(false).Fail("there is no list to close");
      Expression done = std::move(open_.back());
      open_.pop_back();
      Advance();
      Add(std::move(done));
    } else {
      Add(ReadWord());
    }
  }

  Expression ReadWord() {
    Expression word = Here(false);
    while (at_ < text_.size() && IsWordByte(text_[at_])) {
      word.word += static_cast<char>(
          std::tolower(static_cast<unsigned char>(text_[at_])));
      Advance();
      if (word.word.size() > kMaxWord) {
        word.Fail(fmt::format("a word of more than {} bytes", kMaxWord));
      }
    }
    if (word.word.empty()) {
      word.Fail("the byte '" + Printable(text_.substr(at_, 1)) +
                "' cannot be part of PPDDL; names are of letters, digits, "
                "- and _");
    }
    return word;
  }

  void Add(Expression expression) {
    (open_.empty() ? top_ : open_.back().items)
        .push_back(std::move(expression));
  }

  std::string_view text_;
  std::shared_ptr<const std::string> file_;
  size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
  std::vector<Expression> open_;
  std::vector<Expression> top_;
};

}  // namespace

const std::string& Expression::Head() const {
  static const std::string kNone;
  if (!is_list) return word;
  return items.empty() || items.front().is_list ? kNone : items.front().word;
}

void Expression::Fail(const std::string& message) const {
  throw PpddlError(
      fmt::format("{}:{}:{}: {}", file ? *file : "", line, column, message));
}

std::vector<Expression> ReadExpressions(std::string_view text,
                                        const std::string& file) {
  return Reader(text, file).ReadAll();
}

}  // namespace cell::ppddl
