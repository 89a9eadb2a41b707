#include "services/sec_builder/key_frame_extractor.h"

#include <algorithm>
#include <utility>

#include "common/scene/segment_name.h"
#include "common/sec/graph_matching.h"

namespace cell::sec_builder {
namespace {

// X_WO of what the tracks, or the table, are; nullopt if it is not there.
std::optional<Eigen::Isometry3d> PoseOf(const std::string& name,
                                        const Tracks& tracks) {
  if (name == SceneObjects::kTable) return Eigen::Isometry3d::Identity();
  const Track* track = tracks.Find(name);
  if (track == nullptr || track->state == Track::State::kLost) {
    return std::nullopt;
  }
  return track->X_WO;
}

void AddRelativePoses(const TouchGraph& graph, const Tracks& tracks,
                      KeyFrame* frame) {
  for (const auto& [pair, relation] : graph) {
    if (!Touch(graph, pair.first, pair.second)) continue;
    const auto X_WA = PoseOf(pair.first, tracks);
    const auto X_WB = PoseOf(pair.second, tracks);
    if (X_WA && X_WB) {
      frame->relative_poses.emplace(pair, X_WA->inverse() * *X_WB);
    }
  }
}

}  // namespace

KeyFrameExtractor::KeyFrameExtractor(const SceneObjects& scene_objects,
                                     const Params& params)
    : scene_objects_(scene_objects), params_(params) {
  const auto& names = scene_objects_.names();
  for (size_t i = 0; i < names.size(); ++i) {
    for (size_t j = i + 1; j < names.size(); ++j) {
      pairs_.emplace(ObjectPair{names[i], names[j]}, PairFilter(params.pair));
    }
  }
}

std::vector<KeyFrame> KeyFrameExtractor::Update(
    const Tracks& tracks, const Proximities& proximities) {
  NoteWhoIsThere(tracks);
  if (!first_utime_) {
    first_utime_ = tracks.utime;
    for (const auto& [pair, proximity] : proximities) {
      const auto filter = pairs_.find(pair);
      if (filter != pairs_.end()) filter->second.Start(proximity);
    }
  }
  UpdateSegments(tracks, proximities);
  UpdatePairs(tracks.utime, proximities);
  ++num_frames_;
  std::vector<KeyFrame> frames;
  if (num_frames_ < params_.pair.confirm_frames) return frames;
  if (next_index_ == 0) {
    changes_.clear();
    for (const auto& [pair, filter] : pairs_) graph_[pair] = filter.relation();
    frames.push_back(MakeKeyFrame(*first_utime_, tracks));
    return frames;
  }
  while (!changes_.empty()) {
    const int64_t window_end = changes_.front().onset + params_.merge_us;
    if (IsOpen(tracks.utime, window_end)) break;
    if (auto frame = NextKeyFrame(tracks)) frames.push_back(*std::move(frame));
  }
  return frames;
}

bool KeyFrameExtractor::IsOfHandsAlone(const ObjectPair& pair) const {
  return scene_objects_.IsHand(pair.first) &&
         scene_objects_.IsHand(pair.second);
}

void KeyFrameExtractor::NoteWhoIsThere(const Tracks& tracks) {
  for (const std::vector<Track>* some : {&tracks.tracks, &tracks.segments}) {
    for (const Track& track : *some) {
      if (track.state != Track::State::kLost) {
        last_seen_[track.name] = tracks.utime;
      }
    }
  }
  last_seen_[SceneObjects::kTable] = tracks.utime;
}

bool KeyFrameExtractor::IsGone(const std::string& name, int64_t utime) const {
  const auto it = last_seen_.find(name);
  return it == last_seen_.end() || utime - it->second >= params_.absent_us;
}

void KeyFrameExtractor::UpdateSegments(const Tracks& tracks,
                                       const Proximities& proximities) {
  for (const std::string& segment : std::set(segments_)) {
    if (IsGone(segment, tracks.utime)) RemoveSegment(segment);
  }
  for (const Track& track : tracks.segments) {
    if (track.state == Track::State::kTracked &&
        segments_.size() < kMaxSegments && !segments_.contains(track.name)) {
      AddSegment(track.name, tracks.utime, proximities);
    }
  }
}

// Its relations are what they are at first sight, without a change.
void KeyFrameExtractor::AddSegment(const std::string& segment, int64_t utime,
                                   const Proximities& proximities) {
  std::vector<std::string> others = scene_objects_.names();
  others.insert(others.end(), segments_.begin(), segments_.end());
  segments_.insert(segment);
  const Proximity far{2 * params_.pair.release};
  for (const std::string& other : others) {
    const ObjectPair pair = MakePair(segment, other);
    PairFilter filter(params_.pair);
    const auto measured = proximities.find(pair);
    if (!IsGone(other, utime)) {
      filter.Start(measured == proximities.end() ? far : measured->second);
    }
    graph_[pair] = filter.relation();
    pairs_.emplace(pair, filter);
  }
}

void KeyFrameExtractor::RemoveSegment(const std::string& segment) {
  const auto is_of_segment = [&](const ObjectPair& pair) {
    return pair.first == segment || pair.second == segment;
  };
  segments_.erase(segment);
  last_seen_.erase(segment);
  std::erase_if(pairs_, [&](const auto& e) { return is_of_segment(e.first); });
  std::erase_if(graph_, [&](const auto& e) { return is_of_segment(e.first); });
  std::erase_if(changes_, [&](const Change& change) {
    return is_of_segment(change.pair);
  });
}

void KeyFrameExtractor::UpdatePairs(int64_t utime,
                                    const Proximities& proximities) {
  for (auto& [pair, filter] : pairs_) {
    std::optional<PairFilter::Change> change;
    const auto proximity = proximities.find(pair);
    if (IsGone(pair.first, utime) || IsGone(pair.second, utime)) {
      change = filter.Lose(utime);
    } else if (proximity != proximities.end()) {
      change = filter.Update(utime, proximity->second);
    } else {
      filter.Hide();
    }
    if (change && !IsOfHandsAlone(pair)) {
      changes_.push_back({change->onset, pair, change->relation});
    }
  }
  std::stable_sort(
      changes_.begin(), changes_.end(),
      [](const Change& a, const Change& b) { return a.onset < b.onset; });
}

// True while a change that began by `window_end` may still be confirmed.
bool KeyFrameExtractor::IsOpen(int64_t utime, int64_t window_end) const {
  return utime < window_end ||
         std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& entry) {
           const auto since = entry.second.pending_since(utime);
           return since && *since <= window_end && !IsOfHandsAlone(entry.first);
         });
}

// Nothing if the changes cancel out, or only exchange parts that look alike.
std::optional<KeyFrame> KeyFrameExtractor::NextKeyFrame(const Tracks& tracks) {
  const int64_t onset = changes_.front().onset;
  const auto end =
      std::find_if(changes_.begin(), changes_.end(), [&](const Change& change) {
        return change.onset > onset + params_.merge_us;
      });
  TouchGraph graph = graph_;
  std::for_each(changes_.begin(), end, [&](const Change& change) {
    graph[change.pair] = change.relation;
  });
  changes_.erase(changes_.begin(), end);
  if (graph == graph_) return std::nullopt;
  const bool is_new = !MatchGraphs(graph_, graph, params_.alike);
  graph_ = std::move(graph);
  if (!is_new) return std::nullopt;
  for (const auto& [pair, filter] : pairs_) {
    if (IsOfHandsAlone(pair)) graph_[pair] = filter.relation();
  }
  return MakeKeyFrame(onset, tracks);
}

KeyFrame KeyFrameExtractor::MakeKeyFrame(int64_t utime, const Tracks& tracks) {
  KeyFrame frame{utime, next_index_++, {}, {}};
  for (const auto& [pair, relation] : graph_) {
    TouchGraph& part = RelationsWith(pair, &frame);
    part.emplace_hint(part.end(), pair, relation);
  }
  for (const Track& track : tracks.tracks) {
    if (scene_objects_.IsPart(track.name) &&
        track.state != Track::State::kLost) {
      frame.poses.emplace(track.name, track.X_WO);
    }
  }
  AddRelativePoses(graph_, tracks, &frame);
  frame.segment = {last_utime_.value_or(utime), ChannelsOfSegment()};
  last_utime_ = utime;
  last_graph_ = graph_;
  return frame;
}

// Of arms whose hand touches something before or after the change.
std::vector<std::string> KeyFrameExtractor::ChannelsOfSegment() const {
  std::set<std::string> channels = {"TRACKS"};
  for (const auto& [hand, of_arm] : params_.channels) {
    std::set<std::string> others = segments_;
    others.insert(scene_objects_.names().begin(), scene_objects_.names().end());
    for (const std::string& name : others) {
      if (Touch(last_graph_, hand, name) || Touch(graph_, hand, name)) {
        channels.insert(of_arm.begin(), of_arm.end());
      }
    }
  }
  return {channels.begin(), channels.end()};
}

}  // namespace cell::sec_builder
