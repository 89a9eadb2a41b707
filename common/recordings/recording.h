#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cell/pose_t.hpp"

namespace cell {

/// Where the parts and hands were in one episode, as ground truth at the
/// tracker's rate: what remains of a simulated demonstration when its physics
/// need not be computed again. Estimators get it as a stream of tracks
/// (track_stream.h).
///
/// Its file is text, one item per line, words separated by single spaces; an
/// empty line or one that begins with '#' is a comment:
///
///   cell-recording 1             format and version, always the first line
///   task blocks                  folder under deploy/tasks
///   demonstration stack          script of the demonstrator
///   seed 7                       of the run
///   build 0.9                    of the cell that simulated it
///   body hand_left.palm          a part, or <hand>.<box>; numbered from 0
///   body bolt_1
///   frame 96000                  time of the measurement [us], rising
///   0 0.1 -0.2 0.3 1 0 0 0       body 0: position [m], quaternion w x y z
///   1 0.5 0.2 0.01 1 0 0 0         (unit, from the body to W)
///   frame 192000
///   0 0.1 -0.2 0.28              its rotation has not changed
///   1 gone                       body 1 is not there any more
///   said 192000 PlaceBolt        a person named the action [us]
///   said 288000 Turn undone      it undoes the action
///   truth 192000 placed bolt_1 case.hole     what the person has done [us],
///   truth 288000 moved bolt_2                for scorers; it names no action
///   end 2                        number of frames, always the last line
///
/// A body that has no row in a frame is where it was in the last one, and not
/// there before its first row.
struct Recording {
  struct Frame {
    int64_t utime = 0;  ///< [us since the start of the run]
    /// X_WB by index in `bodies`; nullopt: not there.
    std::vector<std::optional<pose_t>> poses;
  };
  /// A person's name for the action that has just been shown.
  struct SpokenName {
    int64_t utime = 0;
    std::string name;
    bool is_undone = false;  ///< what was shown undoes the action
  };

  /// What the person has done, known because it was simulated: for scorers. No
  /// estimator and no learner reads it.
  struct TrueAction {
    enum class Kind : int8_t {
      kPlaced,     ///< at a site
      kTakenBack,  ///< from a site
      kMoved,      ///< from nowhere to nowhere
      kTipped      ///< the same, laid down or raised
    };
    int64_t utime = 0;  ///< the hand let go
    Kind kind = Kind::kMoved;
    std::string part;
    std::string site;  ///< of kPlaced and kTakenBack, else empty

    bool operator==(const TrueAction&) const = default;
  };

  std::string task;
  std::string demonstration;
  uint64_t seed = 0;
  std::string build;
  std::vector<std::string> bodies;  ///< no duplicates
  std::vector<Frame> frames;        ///< utimes rise
  std::vector<SpokenName> spoken;   ///< by utime
  std::vector<TrueAction> truth;    ///< by utime; empty if it is not known
};

/// A text that is no recording: "name:line: message".
class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cell
