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

  std::string task;
  std::string demonstration;
  uint64_t seed = 0;
  std::string build;
  std::vector<std::string> bodies;  ///< no duplicates
  std::vector<Frame> frames;        ///< utimes rise
  std::vector<SpokenName> spoken;   ///< by utime
};

/// A text that is no recording: "name:line: message".
class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cell
