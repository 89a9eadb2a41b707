#include "services/sec_builder/key_frame_emulation.h"

#include <algorithm>
#include <utility>

namespace cell::sec_builder {

KeyFrameEmulation::Params KeyFrameEmulation::Params::FromConfig(
    const Config& config) {
  Params params;
  params.missed = config.Number("missed", 0, 1);
  params.wrong = config.Number("wrong", 0, 1);
  params.late = config.Number("late", 0, 1);
  params.late_us = config.Integer("late_ms", 0, 60'000) * int64_t{1000};
  params.seed = static_cast<uint64_t>(config.Integer("seed", 0, INT32_MAX));
  return params;
}

KeyFrameEmulation::KeyFrameEmulation(const SceneObjects& scene_objects,
                                     const Params& params)
    : scene_objects_(scene_objects), params_(params), random_(params.seed) {}

std::vector<KeyFrame> KeyFrameEmulation::Update(int64_t utime,
                                                std::vector<KeyFrame> frames) {
  if (!params_.is_on()) return frames;
  for (KeyFrame& frame : frames) {
    Perceive(frame.relations);
    if (perceived_ == published_) continue;
    published_ = perceived_;
    frame.relations = perceived_;
    frame.index = next_index_++;
    std::erase_if(frame.relative_poses, [&](const auto& entry) {
      return !Touch(perceived_, entry.first.first, entry.first.second);
    });
    const int64_t due = utime + (Happens(params_.late) ? params_.late_us : 0);
    delayed_.push_back({due, std::move(frame)});
  }
  std::vector<KeyFrame> known;
  while (!delayed_.empty() && delayed_.front().due <= utime) {
    known.push_back(std::move(delayed_.front().frame));
    delayed_.pop_front();
  }
  return known;
}

void KeyFrameEmulation::Reset(uint64_t episode_seed) {
  std::seed_seq seeds = {params_.seed, episode_seed};
  random_.seed(seeds);
  truth_.clear();
  perceived_.clear();
  published_.clear();
  wrong_.clear();
  delayed_.clear();
  next_index_ = 0;
}

bool KeyFrameEmulation::Happens(double probability) {
  return probability > 0 &&
         std::uniform_real_distribution<double>()(random_) < probability;
}

void KeyFrameEmulation::Perceive(const TouchGraph& truth) {
  if (truth_.empty()) {
    truth_ = perceived_ = truth;
    return;
  }
  for (const ObjectPair& pair : std::exchange(wrong_, {})) {
    perceived_[pair] = truth_.at(pair);
  }
  for (const auto& [pair, relation] : truth) {
    if (relation == truth_.at(pair) || Happens(params_.missed)) continue;
    const auto other =
        Happens(params_.wrong) ? AnotherPair(pair) : std::nullopt;
    if (other) wrong_.insert(*other);
    perceived_[other.value_or(pair)] = relation;
  }
  truth_ = truth;
}

/// One that shares an object with it; hands do not touch each other.
std::optional<ObjectPair> KeyFrameEmulation::AnotherPair(
    const ObjectPair& pair) {
  std::vector<ObjectPair> others;
  for (const auto& [other, relation] : truth_) {
    const bool shares =
        other.first == pair.first || other.first == pair.second ||
        other.second == pair.first || other.second == pair.second;
    const bool has_part = scene_objects_.IsPart(other.first) ||
                          scene_objects_.IsPart(other.second);
    if (shares && has_part && other != pair) others.push_back(other);
  }
  if (others.empty()) return std::nullopt;
  std::uniform_int_distribution<size_t> any(0, others.size() - 1);
  return others[any(random_)];
}

}  // namespace cell::sec_builder
