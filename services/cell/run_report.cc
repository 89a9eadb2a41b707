#include "services/cell/run_report.h"

#include <fmt/format.h>

#include <iostream>

#include "common/bus/bus.h"
#include "services/cell/episode_score.h"
#include "services/cell/scene_picture.h"

namespace cell {
namespace {

double SimSeconds(int32_t tick) {
  return tick * kTickUs * 1e-6;
}

}  // namespace

RunReport::RunReport(const RunFolder& run, bool is_hash)
    : run_(run), is_hash_(is_hash), follower_(run.path) {}

void RunReport::Follow() {
  while (const auto message = follower_.Next()) {
    tick_ = message->tick;
    observer_.Put(*message);
    if (message->channel == kTickChannel) {
      if (const auto tick = Decode<tick_t>(*message)) digests_.Put(*tick);
    }
    if (is_hash_) continue;
    for (const std::string& line : narrator_.Tell(*message)) Say(line);
  }
  const double elapsed = progress_.ElapsedSeconds();
  progress_.Show(
      fmt::format("{:.1f} s simulated, {:.1f} x real time, {} "
                  "actions seen",
                  SimSeconds(tick_), SimSeconds(tick_) / elapsed,
                  observer_.record().actions.size()));
}

std::string RunReport::DrawPicture() const {
  const auto& poses = observer_.record().last_poses;
  if (!poses) return "none: the log has no poses";
  const auto path = run_.path / "final.png";
  const auto num_pixels = DrawScene(run_.deployment, *poses, {}, path);
  // Hands are named with a dot, "<hand>.<box>".
  std::string least;
  int least_pixels = 0;
  for (const body_pose_t& body : poses->bodies) {
    if (body.name.find('.') != std::string::npos) continue;
    const auto it = num_pixels.find(body.name);
    const int num = it == num_pixels.end() ? 0 : it->second;
    if (!least.empty() && num >= least_pixels) continue;
    least = body.name;
    least_pixels = num;
  }
  return fmt::format("{} (least to be seen of {}: {} pixels)", path.string(),
                     least, least_pixels);
}

void RunReport::Say(const std::string& line) {
  progress_.Clear();
  (is_hash_ ? std::cerr : std::cout) << line << std::endl;
}

int RunReport::Finish() {
  Follow();
  progress_.Clear();
  const EpisodeRecord& record = observer_.record();
  if (is_hash_) {
    for (const std::string& line : digests_.Lines()) std::cout << line << "\n";
    std::cout << std::flush;
    return record.has_ended ? 0 : 1;
  }
  const EpisodeScore score = Score(record);
  const double elapsed = progress_.ElapsedSeconds();
  const std::string picture = DrawPicture();
  std::cout << fmt::format(
      "\nrecognised {}/{} steps, {} taken back, {} moved, {} invented\n",
      score.num_steps_recognised, score.num_steps, score.num_take_backs_named,
      score.num_moves_named, score.num_invented);
  std::cout << fmt::format("plan: {}\n", score.is_goal_reached
                                             ? "the last state is the goal"
                                             : "the goal is not reached");
  std::cout << fmt::format(
      "{:.1f} s simulated in {:.1f} s: {:.1f} x real time\n", SimSeconds(tick_),
      elapsed, SimSeconds(tick_) / elapsed);
  std::cout << "picture " << picture << "\nlog     "
            << (run_.path / "cell-0001.lcmlog").string() << std::endl;
  return record.has_ended ? 0 : 1;
}

}  // namespace cell
