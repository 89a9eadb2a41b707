#include "common/config/strict_yaml.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace cell {
namespace {

constexpr size_t kMaxDepth = 64;
constexpr int64_t kMaxNodes = 1'000'000;  // with all aliases written out
constexpr char kEnd[] = "end of the file";

/// The length of the UTF-8 sequence at the begin of the text; 0 if it is none,
/// or a control character.
size_t LengthOfCharacter(std::string_view text) {
  const auto byte = [&](size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  if (byte(0) < 0x80) {
    const bool is_text = byte(0) >= 0x20 && byte(0) != 0x7f;
    const bool is_space = text[0] == '\n' || text[0] == '\r' || text[0] == '\t';
    return is_text || is_space ? 1 : 0;
  }
  const size_t length = byte(0) >= 0xf5   ? 0
                        : byte(0) >= 0xf0 ? 4
                        : byte(0) >= 0xe0 ? 3
                        : byte(0) >= 0xc2 ? 2
                                          : 0;
  for (size_t i = 1; i < length; ++i) {
    if (byte(i) < 0x80 || byte(i) >= 0xc0) return 0;
  }
  const bool is_too_long = (byte(0) == 0xe0 && byte(1) < 0xa0) ||
                           (byte(0) == 0xf0 && byte(1) < 0x90);
  const bool is_no_character = (byte(0) == 0xed && byte(1) >= 0xa0) ||
                               (byte(0) == 0xf4 && byte(1) >= 0x90);
  return is_too_long || is_no_character ? 0 : length;
}

[[noreturn]] void Fail(const std::string& file, const std::string& key,
                       int line, const std::string& message) {
  throw ConfigError(ConfigMessage(file, key, line, message));
}

void RequireText(const std::string& text, const std::string& file) {
  int line = 1;
  bool is_indent = true;
  for (size_t i = 0; i < text.size();) {
    const size_t length = LengthOfCharacter(std::string_view(text).substr(i));
    if (length == 0) {
      Fail(file, "", line,
           fmt::format("the byte 0x{:02x} is not text in UTF-8",
                       static_cast<unsigned char>(text[i])));
    }
    if (text[i] == '\t' && is_indent) {
      Fail(file, "", line, "indented by a tab; YAML is indented by spaces");
    }
    if (text[i] == '\n') ++line;
    is_indent = text[i] == '\n' || (is_indent && text[i] == ' ');
    i += length;
  }
}

/// Refuses what LoadStrictYaml() does, event by event.
class Checker final : public YAML::EventHandler {
 public:
  explicit Checker(const std::string& file) : file_(file) {}

  int num_documents() const { return num_documents_; }
  bool has_seen_end() const { return has_seen_end_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++num_documents_ == 2) line_of_second_ = mark.line + 1;
    names_.clear();
  }
  void OnDocumentEnd() override {
    if (num_documents_ > 2) {
      Fail(file_, "", line_of_second_,
           "a second document begins; only one is allowed");
    }
  }
  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    if (!names_.insert(name).second) {
      Refuse(mark, "the anchor &" + name + " already exists");
    }
  }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (IsKeyNext()) Refuse(mark, "a key is empty");
    Begin(mark, "");
    AddSize(anchor, 1);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (IsKeyNext()) Refuse(mark, "an alias cannot be a key");
    Begin(mark, "");
    if (!sizes_.contains(anchor)) {
      Refuse(mark, "an alias refers to a value that contains it");
    }
    AddSize(YAML::NullAnchor, sizes_.at(anchor));
    if (total_ > kMaxNodes) {
      Refuse(mark, fmt::format("with its aliases written out the file has more "
                               "than {} values",
                               kMaxNodes));
    }
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag,
                YAML::anchor_t anchor, const std::string& value) override {
    has_seen_end_ = frames_.empty() && value == kEnd;
    if (IsKeyNext()) return OnKey(mark, tag, value);
    Begin(mark, tag);
    CheckValue(mark, tag, value);
    AddSize(anchor, 1);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag,
                       YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    Open(mark, tag, anchor, false, style == YAML::EmitterStyle::Flow);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag,
                  YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    Open(mark, tag, anchor, true, style == YAML::EmitterStyle::Flow);
  }
  void OnSequenceEnd() override { Close(); }
  void OnMapEnd() override { Close(); }

 private:
  struct Frame {
    bool is_map = false;
    bool is_flow = false;
    YAML::anchor_t anchor = YAML::NullAnchor;
    int64_t size_before = 0;
    std::set<std::string> keys;
    std::optional<std::string> key;  // its value is next
    int num_items = 0;
  };

  [[noreturn]] void Refuse(const YAML::Mark& mark,
                           const std::string& message) const {
    Fail(file_, Path(), mark.line + 1, message);
  }

  std::string Path() const {
    std::string path;
    for (const Frame& frame : frames_) {
      if (frame.is_map && frame.key) {
        path += (path.empty() ? "" : ".") + *frame.key;
      } else if (!frame.is_map && frame.num_items > 0) {
        path += fmt::format("[{}]", frame.num_items - 1);
      }
    }
    return path;
  }

  bool IsKeyNext() const {
    return !frames_.empty() && frames_.back().is_map && !frames_.back().key;
  }

  void OnKey(const YAML::Mark& mark, const std::string& tag,
             const std::string& key) {
    Frame& frame = frames_.back();
    if (key.empty()) Refuse(mark, "a key is empty");
    frame.key = key;
    RequireNoTag(mark, tag);
    RequireUncut(mark, tag, key);
    if (key == "<<") {
      Refuse(mark,
             "merge keys (<<: *anchor) are not supported; write the "
             "keys out");
    }
    if (!frame.keys.insert(key).second) {
      Refuse(mark, "the key already exists");
    }
  }

  void RequireNoTag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    Refuse(mark, "tags (" + tag + ") are not supported");
  }

  void CheckValue(const YAML::Mark& mark, const std::string& tag,
                  const std::string& value) const {
    if (value.find('\0') != std::string::npos) {
      Refuse(mark, "contains the character 0");
    }
    RequireUncut(mark, tag, value);
  }

  // A comma ends a plain text within [ ] and { }, a literal's too.
  void RequireUncut(const YAML::Mark& mark, const std::string& tag,
                    const std::string& text) const {
    const bool is_plain = tag != "!";
    if (is_plain && !frames_.empty() && frames_.back().is_flow &&
        std::count(text.begin(), text.end(), '(') !=
            std::count(text.begin(), text.end(), ')')) {
      Refuse(mark, "'" + text +
                       "' is cut off by a comma; within [ ] and { } it needs "
                       "quotes: \"Name(X, Y)\"");
    }
  }

  // Of a value, whatever it is.
  void Begin(const YAML::Mark& mark, const std::string& tag) {
    if (!frames_.empty() && !frames_.back().is_map) ++frames_.back().num_items;
    RequireNoTag(mark, tag);
  }

  void AddSize(YAML::anchor_t anchor, int64_t size) {
    total_ = std::min(total_ + size, kMaxNodes + 1);
    if (anchor != YAML::NullAnchor) sizes_[anchor] = size;
    if (!frames_.empty()) frames_.back().key.reset();
  }

  void Open(const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor, bool is_map, bool is_flow) {
    if (IsKeyNext()) Refuse(mark, "a map or a list cannot be a key");
    Begin(mark, tag);
    if (frames_.size() == kMaxDepth) {
      Refuse(mark, fmt::format("is nested deeper than {} levels", kMaxDepth));
    }
    frames_.push_back({.is_map = is_map,
                       .is_flow = is_flow,
                       .anchor = anchor,
                       .size_before = total_,
                       .keys = {},
                       .key = {}});
  }

  void Close() {
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    const int64_t size = total_ - frame.size_before + 1;
    total_ = frame.size_before;
    AddSize(frame.anchor, size);
  }

  std::string file_;
  std::vector<Frame> frames_;
  std::set<std::string> names_;              // of anchors
  std::map<YAML::anchor_t, int64_t> sizes_;  // of what is complete
  int64_t total_ = 0;
  int num_documents_ = 0;
  int line_of_second_ = 0;
  bool has_seen_end_ = false;
};

}  // namespace

std::string ConfigMessage(const std::string& file, const std::string& key,
                          int line, const std::string& message) {
  return fmt::format("{}{}{}: {}{}", file, key.empty() ? "" : ":", key, message,
                     line > 0 ? fmt::format(" (line {})", line) : "");
}

YAML::Node LoadStrictYaml(const std::string& text, const std::string& file) {
  RequireText(text, file);
  try {
    // yaml-cpp stops silently where a document or a quote ends too early, and
    // may find documents endlessly: a last one shows that all was read.
    std::istringstream input(text + "\n---\n" + kEnd + "\n");
    YAML::Parser parser(input);
    Checker checker(file);
    while (checker.num_documents() < 3 && parser.HandleNextDocument(checker)) {
    }
    if (checker.num_documents() == 1 && checker.has_seen_end()) {
      throw ConfigError(ConfigMessage(file, "", 0, "is empty"));
    }
    if (checker.num_documents() != 2 || !checker.has_seen_end()) {
      throw ConfigError(ConfigMessage(file, "", 0,
                                      "is not one complete YAML document: is a "
                                      "quote or a bracket left open?"));
    }
    return YAML::Load(text);
  } catch (const YAML::Exception& e) {
    throw ConfigError(
        fmt::format("{}:{}: not YAML: {}", file, e.mark.line + 1, e.msg));
  }
}

}  // namespace cell
