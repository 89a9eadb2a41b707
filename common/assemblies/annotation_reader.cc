#include "common/assemblies/annotation_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "common/text/byte_order_mark.h"
#include "common/text/counted.h"
#include "common/text/nearest.h"
#include "common/text/printable.h"

namespace cell::assemblies {
namespace {

using Problem = AnnotationProblem;

constexpr size_t kNumColumns = 6;  // a seventh, the remark, of mistakes only

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\"";
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// What a message quotes of a cell that may hold anything.
std::string Shortened(std::string_view text) {
  return PrintableName(text, 40);
}

std::vector<std::string_view> Split(std::string_view text, char delimiter) {
  std::vector<std::string_view> parts;
  for (;;) {
    const size_t at = text.find(delimiter);
    parts.push_back(Trimmed(text.substr(0, at)));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

std::optional<double> NumberOf(std::string_view text) {
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

template <class Value>
struct Word {
  Value value;
  bool is_exact;
};

/// The value whose name the word is, or almost is.
template <class Value>
std::optional<Word<Value>> FindWord(
    std::string_view word,
    const std::vector<std::pair<std::string, Value>>& known) {
  std::vector<std::string> names;
  for (const auto& [name, value] : known) {
    if (name == word) return Word<Value>{value, true};
    names.push_back(name);
  }
  const std::string nearest = NearestOf(word, names);
  for (const auto& [name, value] : known) {
    if (!nearest.empty() && name == nearest) return Word<Value>{value, false};
  }
  return {};
}

const std::vector<std::pair<std::string, Verb>> kVerbs = {
    {"attach", Verb::kAttach}, {"detach", Verb::kDetach}};
const std::vector<std::pair<std::string, Label>> kLabels = {
    {"correct", Label::kCorrect},
    {"mistake", Label::kMistake},
    {"correction", Label::kCorrection}};
const std::vector<std::pair<std::string, MistakeKind>> kRemarks = {
    {"wrong order", MistakeKind::kWrongOrder},
    {"wrong position", MistakeKind::kWrongPosition},
    {"shouldn't have happened", MistakeKind::kShouldNotHaveHappened},
    {"previous one is a mistake", MistakeKind::kPreviousIsMistake},
    {"previous one is mistake", MistakeKind::kPreviousIsMistake},
    {"previous is a mistake", MistakeKind::kPreviousIsMistake}};

bool IsVerb(std::string_view text) {
  const auto word = FindWord(text, kVerbs);
  return word && word->is_exact;
}

class Reader {
 public:
  explicit Reader(const std::string& file) {
    result_.sequence.file = file;
    result_.sequence.toy = ToyOf(file);
  }

  AnnotationFile Read(std::string_view text) {
    if (result_.sequence.toy.empty()) {
      Add(Problem::Kind::kNoToy,
          "the file name names no toy; right is ..._ACTOR-TOY_....csv");
    }
    for (const std::string_view line :
         Split(WithoutByteOrderMark(text), '\n')) {
      ++line_;
      if (line.empty()) continue;
      const auto columns = Split(line, ',');
      if (IsHeading(columns)) continue;
      const auto [same, is_new] = lines_.emplace(columns, line_);
      if (!is_new) {
        Add(Problem::Kind::kRepeatedRow,
            fmt::format("the same as line {}; both are read", same->second));
      }
      ReadRow(columns);
    }
    line_ = 1;
    if (result_.sequence.actions.empty()) {
      Add(Problem::Kind::kEmptyFile, "holds no action");
    }
    return std::move(result_);
  }

 private:
  using Columns = std::vector<std::string_view>;

  void Add(Problem::Kind kind, std::string text) {
    result_.problems.push_back(
        {kind, result_.sequence.file, std::max(line_, 1), std::move(text)});
  }

  bool IsHeading(const Columns& columns) const {
    return line_ == 1 && columns.size() >= kNumColumns &&
           !NumberOf(columns[0]) && !NumberOf(columns[1]) &&
           !FindWord(columns[2], kVerbs);
  }

  void ReadRow(Columns columns) {
    ++result_.num_rows;
    if (columns.size() + 1 < kNumColumns) {
      Skip(Problem::Kind::kMissingColumns,
           fmt::format("{}; right are first frame, last frame, verb, part, "
                       "part, label, remark",
                       Counted(std::ssize(columns), "column")));
      return;
    }
    if (columns.size() < kNumColumns) {
      Add(Problem::Kind::kMissingColumns,
          "no column of labels; the row is not scored");
    }
    columns.resize(std::max(columns.size(), kNumColumns + 1));
    if (IsVerb(columns[3]) || IsVerb(columns[4])) {
      Skip(Problem::Kind::kVerbAsPart,
           fmt::format("'{}' is a verb, no part: right are first frame, last "
                       "frame, verb, part, part, label, remark",
                       columns[IsVerb(columns[3]) ? 3 : 4]));
      return;
    }
    const PartPair pair = MakePair(columns[3], columns[4]);
    if (pair.first.empty()) {
      Skip(Problem::Kind::kMissingName, "a part has no name");
      return;
    }
    CheckFrames(columns);
    AddAction(columns, pair);
  }

  void Skip(Problem::Kind kind, const std::string& text) {
    Add(kind, text + "; the row is skipped");
    ++result_.num_skipped;
  }

  void AddAction(const Columns& columns, const PartPair& pair) {
    AssemblyAction action;
    action.line = line_;
    action.pair = pair;
    action.verb = ReadVerb(columns[2], pair);
    action.label = ReadLabel(columns[5]);
    action.kind = ReadRemark(columns[6], action.label);
    if (pair.is_of_one_name()) {
      Add(Problem::Kind::kOnePart,
          fmt::format("'{}' with itself; taken as two parts of one name, "
                      "never a mistake",
                      pair.first));
    }
    if (action.verb == Verb::kAttach) {
      attached_.insert(pair);
    } else {
      attached_.erase(pair);
    }
    result_.sequence.actions.push_back(action);
  }

  void CheckFrames(const Columns& columns) {
    const auto first = NumberOf(columns[0]);
    const auto last = NumberOf(columns[1]);
    if (first && last && *first <= *last) return;
    Add(Problem::Kind::kBadFrames,
        fmt::format("frames '{}' to '{}' are no stretch of time; the order of "
                    "the rows counts",
                    Shortened(columns[0]), Shortened(columns[1])));
  }

  Verb ReadVerb(std::string_view text, const PartPair& pair) {
    const auto word = FindWord(text, kVerbs);
    if (word && word->is_exact) return word->value;
    const bool is_attached = attached_.contains(pair);
    const Verb verb = word          ? word->value
                      : is_attached ? Verb::kDetach
                                    : Verb::kAttach;
    std::string said =
        fmt::format("'{}' is no verb; right are attach and detach; read as {}",
                    Shortened(text), NameOf(verb));
    if (!word) {
      said += fmt::format(", since {} {} attached", Show(pair),
                          is_attached ? "is" : "is not");
    }
    Add(Problem::Kind::kUnknownVerb, std::move(said));
    return verb;
  }

  std::optional<Label> ReadLabel(std::string_view text) {
    const auto word = FindWord(text, kLabels);
    if (word && word->is_exact) return word->value;
    if (text.empty()) return {};
    Add(Problem::Kind::kUnknownLabel,
        fmt::format("'{}' is no label; right are correct, mistake and "
                    "correction; {}",
                    Shortened(text),
                    word ? fmt::format("read as {}", NameOf(word->value))
                         : "the row is not scored"));
    if (!word) return {};
    return word->value;
  }

  MistakeKind ReadRemark(std::string_view text, std::optional<Label> label) {
    if (label != Label::kMistake) return MistakeKind::kNone;
    if (text.empty()) {
      Add(Problem::Kind::kMissingRemark,
          "a mistake without a remark; its kind is not known");
      return MistakeKind::kNone;
    }
    const auto word = FindWord(text, kRemarks);
    if (word && word->is_exact) return word->value;
    Add(Problem::Kind::kUnknownRemark,
        fmt::format("'{}' is no known remark; {}", Shortened(text),
                    word ? fmt::format("read as {}", NameOf(word->value))
                         : "the kind is not known"));
    return word ? word->value : MistakeKind::kNone;
  }

  AnnotationFile result_;
  std::set<PartPair> attached_;
  std::map<Columns, int> lines_;  // of the rows so far
  int line_ = 0;
};

}  // namespace

const char* NameOf(Verb verb) {
  return verb == Verb::kAttach ? "attach" : "detach";
}

const char* NameOf(Label label) {
  constexpr const char* kNames[] = {"correct", "mistake", "correction"};
  return kNames[static_cast<int>(label)];
}

const char* NameOf(MistakeKind kind) {
  constexpr const char* kNames[] = {"", "wrong order", "wrong position",
                                    "shouldn't have happened",
                                    "previous one is a mistake"};
  return kNames[static_cast<int>(kind)];
}

const char* NameOf(AnnotationProblem::Kind kind) {
  constexpr const char* kNames[] = {"files without an action",
                                    "file names without a toy",
                                    "rows without all columns",
                                    "rows without a part's name",
                                    "rows with a verb as a part",
                                    "rows that repeat another",
                                    "wrong frames",
                                    "wrong verbs",
                                    "wrong labels",
                                    "mistakes without a remark",
                                    "misspelt or unknown remarks",
                                    "pairs of a part with itself"};
  return kNames[static_cast<int>(kind)];
}

std::string Show(const AnnotationProblem& problem) {
  return fmt::format("{}:{}: {}", problem.file, problem.line, problem.text);
}

std::string ToyOf(std::string_view file_name) {
  file_name.remove_prefix(file_name.find_last_of('/') + 1);
  for (const std::string_view word : Split(file_name, '_')) {
    const size_t dash = word.find('-');
    if (dash == std::string_view::npos || dash == 0 ||
        dash + 1 == word.size()) {
      continue;
    }
    const auto is_digit = [](char c) {
      return c >= '0' && c <= '9';
    };
    if (std::ranges::all_of(word.substr(0, dash), is_digit)) {
      return std::string(word.substr(dash + 1));
    }
  }
  return {};
}

AnnotationFile ReadAnnotations(std::string_view text, const std::string& file) {
  return Reader(file).Read(text);
}

}  // namespace cell::assemblies
