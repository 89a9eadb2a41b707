#include "common/recordings/recording_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "common/bus/decode.h"
#include "common/config/decimal.h"
#include "common/geometry/pose.h"
#include "common/text/printable.h"

namespace cell {
namespace {

constexpr std::string_view kFormat = "cell-recording";
constexpr std::string_view kVersion = "1";
constexpr std::string_view kUndone = "undone";
using TrueKind = Recording::TrueAction::Kind;
/// In the order of the kinds.
constexpr std::array<std::string_view, 4> kTrueKinds = {"placed", "taken_back",
                                                        "moved", "tipped"};
constexpr size_t kMaxBodies = 1000;
constexpr int kQuaternionDecimals = 5;  // PoseFromMessage() wants 1e-4

using Words = std::vector<std::string_view>;

Words WordsIn(std::string_view line) {
  Words words;
  for (size_t begin = 0; begin <= line.size();) {
    const size_t end = std::min(line.find(' ', begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Reads line after line; the recording is whole once `end` was read.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name)
      : text_(text), name_(name) {}

  Recording Read() {
    RequireFormat();
    while (NextLine()) {
      const Words words = WordsIn(line_);
      if (has_end_) Fail("nothing may follow 'end'");
      if (words[0] == "frame") {
        ReadFrame(words);
      } else if (words[0] == "end") {
        ReadEnd(words);
      } else if (words[0] == "said") {
        ReadSaid(words);
      } else if (words[0] == "truth") {
        ReadTruth(words);
      } else if (recording_.frames.empty()) {
        ReadHead(words);
      } else {
        ReadRow(words);
      }
    }
    if (!has_end_) Fail("the file is cut off: its last line is not 'end N'");
    return std::move(recording_);
  }

 private:
  [[noreturn]] void Fail(const std::string& message) const {
    throw RecordingError(fmt::format("{}:{}: {}", name_, number_, message));
  }

  bool NextRawLine() {
    if (position_ >= text_.size()) return false;
    const size_t end = std::min(text_.find('\n', position_), text_.size());
    line_ = text_.substr(position_, end - position_);
    position_ = end + 1;
    ++number_;
    return true;
  }

  bool NextLine() {
    while (NextRawLine()) {
      if (!line_.empty() && line_[0] != '#') return true;
    }
    return false;
  }

  void RequireFormat() {
    const Words words = NextRawLine() ? WordsIn(line_) : Words{};
    if (words.size() != 2 || words[0] != kFormat) {
      number_ = 1;
      Fail(fmt::format("is no recording: its first line must be '{} {}'",
                       kFormat, kVersion));
    }
    if (words[1] != kVersion) {
      Fail(
          fmt::format("has version {} of the format, but this build reads "
                      "version {}",
                      Printable(words[1]), kVersion));
    }
  }

  void RequireCount(const Words& words, size_t count,
                    std::string_view form) const {
    if (words.size() != count) Fail(fmt::format("must read '{}'", form));
  }

  template <class T>
  T Number(std::string_view word, std::string_view what) const {
    const Result<T> value = ParseDecimal<T>(word);
    if (!value) {
      Fail(fmt::format("{} '{}' {}", what, Printable(word), value.reason()));
    }
    return *value;
  }

  int64_t Utime(std::string_view word) const {
    const auto utime = Number<int64_t>(word, "time");
    if (!IsUtime(utime)) {
      Fail(fmt::format("time {} is not between 0 and {} us", utime, kMaxUtime));
    }
    return utime;
  }

  void ReadHead(const Words& words) {
    const std::string_view key = words[0];
    if (key == "body") return ReadBody(words);
    const std::array<std::pair<std::string_view, std::string*>, 3> texts = {
        {{"task", &recording_.task},
         {"demonstration", &recording_.demonstration},
         {"build", &recording_.build}}};
    for (const auto& [name, value] : texts) {
      if (key != name) continue;
      RequireCount(words, 2, fmt::format("{} NAME", name));
      if (!value->empty()) Fail(fmt::format("a second '{}'", name));
      *value = words[1];
      return;
    }
    if (key != "seed") {
      Fail(
          fmt::format("'{}' is not known here: task, demonstration, seed, "
                      "build, body, or the first frame",
                      Printable(key)));
    }
    RequireCount(words, 2, "seed NUMBER");
    recording_.seed = Number<uint64_t>(words[1], "seed");
  }

  void ReadBody(const Words& words) {
    RequireCount(words, 2, "body NAME");
    if (words[1].empty()) Fail("must read 'body NAME'");
    if (std::ranges::count(recording_.bodies, words[1]) > 0) {
      Fail(fmt::format("a second body '{}'", Printable(words[1])));
    }
    if (recording_.bodies.size() == kMaxBodies) {
      Fail(fmt::format("more than {} bodies", kMaxBodies));
    }
    recording_.bodies.emplace_back(words[1]);
  }

  void ReadFrame(const Words& words) {
    RequireCount(words, 2, "frame UTIME");
    const int64_t utime = Utime(words[1]);
    auto& frames = recording_.frames;
    if (!frames.empty() && utime <= frames.back().utime) {
      Fail(fmt::format("frame {} is not later than the last one, {}", utime,
                       frames.back().utime));
    }
    frames.push_back({utime, frames.empty()
                                 ? std::vector<std::optional<pose_t>>(
                                       recording_.bodies.size())
                                 : frames.back().poses});
    has_row_.assign(recording_.bodies.size(), false);
  }

  void ReadRow(const Words& words) {
    const auto index = Number<uint64_t>(words[0], "body");
    if (index >= recording_.bodies.size()) {
      Fail(fmt::format("body {} is not there: they are numbered from 0 to {}",
                       index, recording_.bodies.size() - 1));
    }
    if (has_row_[index]) {
      Fail(fmt::format("a second row of body {} in this frame", index));
    }
    has_row_[index] = true;
    auto& pose = recording_.frames.back().poses[index];
    if (words.size() == 2 && words[1] == "gone") {
      pose.reset();
    } else {
      ReadPose(words, pose);
    }
  }

  void ReadPose(const Words& words, std::optional<pose_t>& pose) const {
    const bool has_rotation = words.size() == 8;
    if (!has_rotation && words.size() != 4) {
      Fail("must read 'BODY x y z [qw qx qy qz]' or 'BODY gone'");
    }
    if (!has_rotation && !pose) {
      Fail("the first row of a body must have its rotation, too");
    }
    if (!pose) pose.emplace();
    for (size_t i = 0; i < 3; ++i) {
      pose->position[i] = Number<double>(words[1 + i], "position");
    }
    for (size_t i = 0; has_rotation && i < 4; ++i) {
      pose->quat_wxyz[i] = Number<double>(words[4 + i], "quaternion");
    }
    if (!PoseFromMessage(*pose)) {
      Fail(
          "is no pose: positions lie within 100 m, quaternions are of length "
          "1");
    }
  }

  void ReadSaid(const Words& words) {
    const bool is_undone = words.size() == 4 && words[3] == kUndone;
    if ((words.size() != 3 && !is_undone) || words[2].empty()) {
      Fail("must read 'said UTIME NAME' or 'said UTIME NAME undone'");
    }
    const int64_t utime = Utime(words[1]);
    auto& spoken = recording_.spoken;
    if (!spoken.empty() && utime < spoken.back().utime) {
      Fail(fmt::format("said at {}, but the name before it at {}", utime,
                       spoken.back().utime));
    }
    spoken.push_back({utime, std::string(words[2]), is_undone});
  }

  void ReadTruth(const Words& words) {
    const auto kind = std::ranges::find(
        kTrueKinds, words.size() > 2 ? words[2] : std::string_view());
    const auto index = static_cast<size_t>(kind - kTrueKinds.begin());
    const bool has_site = index <= static_cast<size_t>(TrueKind::kTakenBack);
    if (kind == kTrueKinds.end() || words.size() != (has_site ? 5 : 4) ||
        words[3].empty() || words.back().empty()) {
      Fail(
          "must read 'truth UTIME placed|taken_back PART SITE' or 'truth UTIME "
          "moved|tipped PART'");
    }
    const int64_t utime = Utime(words[1]);
    auto& truth = recording_.truth;
    if (!truth.empty() && utime < truth.back().utime) {
      Fail(fmt::format("truth at {}, but the action before it at {}", utime,
                       truth.back().utime));
    }
    truth.push_back({utime, static_cast<TrueKind>(index), std::string(words[3]),
                     has_site ? std::string(words[4]) : std::string()});
  }

  void ReadEnd(const Words& words) {
    RequireCount(words, 2, "end NUMBER-OF-FRAMES");
    const auto count = Number<uint64_t>(words[1], "number of frames");
    if (count != recording_.frames.size()) {
      Fail(fmt::format("says that there are {} frames, but there are {}", count,
                       recording_.frames.size()));
    }
    if (recording_.task.empty()) Fail("no line 'task NAME' before the frames");
    has_end_ = true;
  }

  std::string_view text_;
  const std::string& name_;
  size_t position_ = 0;
  int number_ = 0;
  std::string_view line_;
  std::vector<bool> has_row_;  // each body, in the frame that is read
  bool has_end_ = false;
  Recording recording_;
};

std::string Shortest(double value) {
  std::array<char, 32> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

std::string Text(double value, std::optional<int> decimals) {
  if (!decimals) return Shortest(value);
  const double unit = std::pow(10.0, *decimals);
  // Of the rounded value: "0.1" rather than "0.10000", and no "-0".
  return Shortest(std::round(value * unit) / unit + 0.0);
}

struct PoseText {
  std::string position, rotation;
  bool operator==(const PoseText&) const = default;
};

PoseText TextOf(const pose_t& pose, std::optional<int> decimals) {
  PoseText text;
  for (const double value : pose.position) {
    text.position += " " + Text(value, decimals);
  }
  if (decimals) decimals = std::max(*decimals, kQuaternionDecimals);
  for (const double value : pose.quat_wxyz) {
    text.rotation += " " + Text(value, decimals);
  }
  return text;
}

std::string RequireWord(const std::string& word) {
  if (word.empty() || word != Printable(word) ||
      word.find(' ') != std::string::npos) {
    throw std::invalid_argument("no word for a recording: '" + Printable(word) +
                                "'");
  }
  return word;
}

std::string HeadOf(const Recording& recording) {
  std::string text = fmt::format("{} {}\n", kFormat, kVersion);
  text += "task " + RequireWord(recording.task) + "\n";
  for (const auto& [key, value] :
       {std::pair{"demonstration", &recording.demonstration},
        {"build", &recording.build}}) {
    if (value->empty()) continue;
    text += std::string(key) + " " + RequireWord(*value) + "\n";
  }
  text += fmt::format("seed {}\n", recording.seed);
  for (const std::string& body : recording.bodies) {
    text += "body " + RequireWord(body) + "\n";
  }
  return text;
}

std::string LineOf(const Recording::TrueAction& action) {
  return fmt::format("truth {} {} {}{}\n", action.utime,
                     kTrueKinds.at(static_cast<size_t>(action.kind)),
                     RequireWord(action.part),
                     action.site.empty() ? "" : " " + RequireWord(action.site));
}

void RequireSound(const Recording& recording) {
  int64_t last = -1;
  for (const Recording::Frame& frame : recording.frames) {
    if (frame.utime <= last || frame.poses.size() != recording.bodies.size()) {
      throw std::invalid_argument(fmt::format(
          "frame {} of a recording: {} poses of {} bodies, after "
          "frame {}",
          frame.utime, frame.poses.size(), recording.bodies.size(), last));
    }
    last = frame.utime;
  }
}

}  // namespace

Recording RecordingFromText(std::string_view text, const std::string& name) {
  return Reader(text, name).Read();
}

std::string RecordingToText(const Recording& recording,
                            std::optional<int> decimals) {
  RequireSound(recording);
  std::string text = HeadOf(recording);
  std::vector<std::optional<PoseText>> last(recording.bodies.size());
  auto said = recording.spoken.begin();
  auto done = recording.truth.begin();
  const auto append_events_before = [&](int64_t utime) {
    for (; said != recording.spoken.end() && said->utime < utime; ++said) {
      text +=
          fmt::format("said {} {}{}\n", said->utime, RequireWord(said->name),
                      said->is_undone ? " undone" : "");
    }
    for (; done != recording.truth.end() && done->utime < utime; ++done) {
      text += LineOf(*done);
    }
  };
  for (const Recording::Frame& frame : recording.frames) {
    append_events_before(frame.utime);
    text += fmt::format("frame {}\n", frame.utime);
    for (size_t i = 0; i < frame.poses.size(); ++i) {
      std::optional<PoseText> now;
      if (frame.poses[i]) now = TextOf(*frame.poses[i], decimals);
      if (now == last[i]) continue;
      text += std::to_string(i);
      if (!now) {
        text += " gone";
      } else {
        text += now->position;
        if (!last[i] || last[i]->rotation != now->rotation) {
          text += now->rotation;
        }
      }
      text += "\n";
      last[i] = std::move(now);
    }
  }
  append_events_before(INT64_MAX);
  return text + fmt::format("end {}\n", recording.frames.size());
}

}  // namespace cell
