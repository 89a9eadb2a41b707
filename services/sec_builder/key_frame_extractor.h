#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/scene/key_frame.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"
#include "common/sec/relation_matrix.h"
#include "services/sec_builder/pair_filter.h"
#include "services/sec_builder/proximity.h"

namespace cell::sec_builder {

/// Condenses a stream of scenes into key frames, one per lasting change of
/// topology (section V-B). Changes that begin together are one key frame; it
/// is dated back to the first of them and comes as soon as none that belongs to
/// it can still be confirmed.
///
/// Exact graph matching (MatchGraphs) decides whether a topology differs from
/// the one before. Tracked objects are matched by their names, so that a
/// tracker that confuses parts of the same shape starts no key frame.
///
/// The events are those of the parts: contact between two hands (a person's and
/// a gripper) is none, although the relations of key frames include it. That an
/// unmodelled segment begins or ceases to touch something is one; that it comes
/// and goes is none, since trackers lose what they have no model of.
class KeyFrameExtractor {
 public:
  struct Params {
    PairFilter::Params pair;
    int64_t merge_us = 150'000;     ///< changes so near in time are one
    int64_t absent_us = 1'000'000;  ///< without a track for so long: gone
    /// Channels with the trajectory and the forces of the arm that a hand
    /// belongs to, by hand; none of a person's.
    std::map<std::string, std::vector<std::string>> channels = {};
    /// Parts that look alike, by name, and what they are.
    ObjectTypes alike = {};
  };

  KeyFrameExtractor(const SceneObjects& scene_objects, const Params& params);

  /// Takes the tracks and what was measured of them. Key frame 0 is the
  /// topology of the first scene, in frame `confirm_frames`.
  /// @pre tracks are later than the last ones.
  std::vector<KeyFrame> Update(const Tracks& tracks,
                               const Proximities& proximities);

 private:
  struct Change {
    int64_t onset;
    ObjectPair pair;
    Relation relation;
  };

  bool IsOfHandsAlone(const ObjectPair& pair) const;
  void NoteWhoIsThere(const Tracks& tracks);
  bool IsGone(const std::string& name, int64_t utime) const;
  void UpdateSegments(const Tracks& tracks, const Proximities& proximities);
  void AddSegment(const std::string& segment, int64_t utime,
                  const Proximities& proximities);
  void RemoveSegment(const std::string& segment);
  void UpdatePairs(int64_t utime, const Proximities& proximities);
  bool IsOpen(int64_t utime, int64_t window_end) const;
  std::optional<KeyFrame> NextKeyFrame(const Tracks& tracks);
  KeyFrame MakeKeyFrame(int64_t utime, const Tracks& tracks);
  std::vector<std::string> ChannelsOfSegment() const;

  SceneObjects scene_objects_;
  Params params_;
  std::map<ObjectPair, PairFilter> pairs_;
  std::set<std::string> segments_;  // that are there
  std::map<std::string, int64_t> last_seen_;
  std::vector<Change> changes_;  // confirmed, not yet in a key frame
  TouchGraph graph_;             // of the last key frame
  std::optional<int64_t> first_utime_;
  TouchGraph last_graph_;              // of the key frame before that
  std::optional<int64_t> last_utime_;  // of the last key frame
  int num_frames_ = 0;
  int64_t next_index_ = 0;
};

}  // namespace cell::sec_builder
