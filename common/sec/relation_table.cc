#include "common/sec/relation_table.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <ranges>
#include <stdexcept>
#include <vector>

#include "common/text/byte_order_mark.h"
#include "common/text/printable.h"

namespace cell {
namespace {

template <class Number>
std::optional<Number> Parse(std::string_view text) {
  Number number{};
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = end == text.data() + text.size();
  return error == std::errc() && is_whole ? std::optional(number)
                                          : std::nullopt;
}

std::vector<std::string_view> Split(std::string_view text, char delimiter) {
  std::vector<std::string_view> pieces;
  while (true) {
    const size_t end = text.find(delimiter);
    pieces.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

class TableReader {
 public:
  TableReader(double threshold, std::string source)
      : threshold_(threshold), source_(std::move(source)) {}

  EventChain Read(std::string_view table) {
    for (std::string_view text : Split(WithoutByteOrderMark(table), '\n')) {
      ++line_;
      if (text.ends_with('\r')) text.remove_suffix(1);
      if (text.empty()) continue;
      pairs_.empty() ? ReadNames(Split(text, ','))
                     : ReadFrame(Split(text, ','));
    }
    if (pairs_.empty()) Fail("the table is empty; a line of names is expected");
    if (chain_.num_columns() == 0) Fail("the table has no frame");
    const EventChain changing = chain_.ChangingRows().DistinctColumns();
    if (changing.num_rows() == 0) {
      Fail(fmt::format("no relation changes (threshold {})", threshold_));
    }
    return changing;
  }

 private:
  [[noreturn]] void Fail(const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", source_, line_, what));
  }

  void ReadNames(const std::vector<std::string_view>& names) {
    if (names.front() != "frame" || names.size() < 2) {
      Fail("expected names: 'frame', then a pair for each column");
    }
    TouchGraph known;
    for (const std::string_view name : names | std::views::drop(1)) {
      const size_t slash = name.find('/');
      const size_t end = slash == name.npos ? name.find('_') : slash;
      if (end == 0 || end == name.npos || end + 1 == name.size()) {
        Fail("'" + Printable(name) + "' names no pair, such as hand_cup");
      }
      if (name.substr(0, end) == name.substr(end + 1)) {
        Fail("'" + Printable(name) + "' names one object twice");
      }
      pairs_.push_back(MakePair(std::string(name.substr(0, end)),
                                std::string(name.substr(end + 1))));
      if (!known.emplace(pairs_.back(), Relation{}).second) {
        Fail("the pair '" + Printable(name) + "' is there twice");
      }
    }
  }

  void ReadFrame(const std::vector<std::string_view>& values) {
    if (values.size() != pairs_.size() + 1) {
      Fail(fmt::format("{} values; the line of names has {}", values.size(),
                       pairs_.size() + 1));
    }
    const auto frame = Parse<int64_t>(values.front());
    if (!frame) {
      Fail("frame '" + Printable(values.front()) + "' is no whole number");
    }
    if (last_frame_ && *frame == *last_frame_) {
      Fail(fmt::format("frame {} is there twice", *frame));
    }
    if (last_frame_ && *frame < *last_frame_) {
      Fail(fmt::format("frame {} after frame {}: frames must increase", *frame,
                       *last_frame_));
    }
    last_frame_ = frame;
    TouchGraph relations;
    for (size_t i = 0; i < pairs_.size(); ++i) {
      relations[pairs_[i]] = RelationIn(values[i + 1]);
    }
    chain_.Append(relations);
  }

  Relation RelationIn(std::string_view text) const {
    const auto value = Parse<double>(text);
    if (value == 2) return Relation::kOverlapping;
    if (value == 9) return Relation::kAbsent;
    if (value && *value >= 0 && *value <= 1) {
      return *value >= threshold_ ? Relation::kTouching
                                  : Relation::kNotTouching;
    }
    Fail("'" + Printable(text) +
         "' is no relation: a number from 0 to 1, 2 or 9 is expected");
  }

  double threshold_;
  std::string source_;
  int line_ = 0;
  std::vector<ObjectPair> pairs_;  // of the columns, in their order
  std::optional<int64_t> last_frame_;
  EventChain chain_;
};

}  // namespace

EventChain ChainFromTable(std::string_view table, double threshold,
                          const std::string& source) {
  return TableReader(threshold, source).Read(table);
}

}  // namespace cell
