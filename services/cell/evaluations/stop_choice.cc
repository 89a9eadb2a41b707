#include "services/cell/evaluations/stop_choice.h"

#include <random>
#include <utility>
#include <vector>

namespace cell::cli {
namespace {

constexpr int kNumKinds = 3;
constexpr int32_t kHoldTicks = 125;
constexpr int32_t kDeathTicks[] = {13, 60, 375};  // 0.1, 0.5, 3 s
/// Of the skills of a kind in a run; prime, so that each part meets all.
constexpr uint64_t kPerRun = 7;

/// A stage and about how long it lasts [ticks].
using Stage = std::pair<const char*, int32_t>;

const std::vector<Stage>& StagesOf(StoppedSkill skill) {
  static const std::vector<Stage> insert = {
      {"open", 15},  {"go to ", 120}, {"reach", 150},    {"close", 25},
      {"lift", 150}, {"carry", 150},  {"tare", 25},      {"seat", 80},
      {"seat", 400}, {"let go", 15},  {"draw back", 150}};
  static const std::vector<Stage> turning = {
      {"turn", 60},  {"seat", 200},  {"turn", 400},  {"let go", 18},
      {"turn", 500}, {"carry", 150}, {"turn", 250},  {"draw back", 150},
      {"turn", 600}, {"close", 25},  {"let go", 30}, {"reach", 150}};
  static const std::vector<Stage> set_down = {
      {"reach", 150},    {"close", 25},  {"lift", 150},      {"carry", 150},
      {"set down", 150}, {"let go", 18}, {"draw back", 150}, {"go home", 100}};
  switch (skill) {
    case StoppedSkill::kInsert:
      return insert;
    case StoppedSkill::kInsertTurning:
      return turning;
    case StoppedSkill::kSetDown:
      break;
  }
  return set_down;
}

}  // namespace

const char* NameOf(StopKind kind) {
  switch (kind) {
    case StopKind::kProtective:
      return "protective stop";
    case StopKind::kHold:
      return "operator's hold";
    case StopKind::kDeath:
      break;
  }
  return "crash of the arm's service";
}

StopChoice ChooseStop(StoppedSkill skill, uint64_t seed, int index) {
  const auto& stages = StagesOf(skill);
  const uint64_t number = kPerRun * seed + static_cast<uint64_t>(index);
  const uint64_t round = number / stages.size(), place = number % stages.size();
  std::mt19937_64 random(number);
  const auto& [stage, length] = stages[place];
  StopChoice choice{stage, 0, {}, kHoldTicks};
  choice.delay = static_cast<int32_t>(random() % static_cast<uint64_t>(length));
  choice.kind = static_cast<StopKind>((round + place) % kNumKinds);
  if (choice.kind == StopKind::kDeath) {
    choice.duration = kDeathTicks[random() % std::size(kDeathTicks)];
  }
  return choice;
}

}  // namespace cell::cli
