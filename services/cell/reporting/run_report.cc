#include "services/cell/reporting/run_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "common/bus/bus.h"
#include "common/bus/decode.h"
#include "common/task/task.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/pictures/scene_picture.h"
#include "services/cell/scoring/assembly_score.h"
#include "services/cell/scoring/episode_score.h"

namespace cell::cli {

namespace {

double SimSeconds(int32_t tick) {
  return tick * kTickUs * 1e-6;
}

std::string SummarizeWatched(const EpisodeRecord& record) {
  const EpisodeScore score = Score(record);
  return fmt::format(
      "recognised {} of {}; {} taken back, {} only moved; {}\n{}",
      score.num_steps_recognised, Counted(score.num_steps, "step"),
      Counted(score.num_take_backs_named, "part"),
      Counted(score.num_moves_named, "part"),
      Counted(score.num_invented, "false recognition"),
      score.is_goal_reached ? "the goal is reached"
                            : "the goal is not reached");
}

// The last message of the process that ended the run because no operator is
// there.
std::optional<std::string> WhyUnattended(const EpisodeRecord& record) {
  const auto at =
      std::ranges::find(record.alerts, alert_t::UNATTENDED, &alert_t::cause);
  if (at == record.alerts.end()) return std::nullopt;
  return at->text;
}

// True if the cell waited for a person, and none was there.
bool HasWaitedInVain(const EpisodeRecord& record) {
  return WhyUnattended(record) ||
         (record.episode.agent == "robot" && record.execution &&
          record.execution->state == execution_t::STUCK);
}

// Why the robot has not reached the goal, from its last message.
std::string WhyNot(const EpisodeRecord& record) {
  if (const auto why = WhyUnattended(record)) return *why;
  if (record.execution && record.execution->state == execution_t::STUCK) {
    return "the robot asks: " + Printable(record.execution->text);
  }
  for (auto it = record.results.rbegin(); it != record.results.rend(); ++it) {
    if (it->outcome != skill_result_t::SUCCEEDED) return Printable(it->reason);
  }
  return "the reason is not known";
}

std::string SummarizeExecuted(const EpisodeRecord& record,
                              const SuccessCriterion& success) {
  if (!record.pose_history.has_both()) return "nothing was done";
  const AssemblyScore score = ScoreAssembly(
      record.pose_history.earlier(), record.pose_history.last(), success);
  // Sites with a thread, and others: seated, all.
  int num[2][2] = {};
  for (const bool is_seated : {true, false}) {
    for (const auto& site : is_seated ? score.seated : score.missing) {
      const bool is_thread = IsThreaded(site, success.parts);
      num[is_thread][0] += is_seated;
      ++num[is_thread][1];
    }
  }
  std::string text = fmt::format("assembled {} of {}", num[0][0],
                                 Counted(num[0][1], "placement"));
  if (num[1][1] > 0) {
    text += fmt::format(", screwed {} of {}", num[1][0], num[1][1]);
  }
  if (score.is_complete()) return text + ": nothing is missing";
  return fmt::format(
      "{}; missing {}\nwhy: {}", text,
      Printable(fmt::format("{}", fmt::join(score.missing, ", "))),
      WhyNot(record));
}

}  // namespace

RunReport::RunReport(const RunFolder& run, const RunOptions& options)
    : run_(run),
      is_hash_(options.is_hash),
      follower_(run.path),
      narrator_(options.is_verbose) {}

void RunReport::Follow() {
  while (const auto message = follower_.Next()) {
    tick_ = message->tick;
    observer_.Put(*message);
    if (message->channel == kTickChannel) {
      if (const auto tick = Decode<tick_t>(*message)) digests_.Put(*tick);
    }
    if (is_hash_) continue;
    for (const std::string& line : narrator_.Describe(*message)) Print(line);
  }
  const double elapsed = progress_.ElapsedSeconds();
  progress_.Show(fmt::format(
      "{:.1f} s simulated, {:.1f} x real time, {} "
      "seen",
      SimSeconds(tick_), SimSeconds(tick_) / elapsed,
      Counted(static_cast<int64_t>(observer_.record().actions.size()),
              "action")));
}

std::string RunReport::DrawPicture(const EpisodeRecord& record,
                                   const std::string& name) const {
  if (record.pose_history.is_empty()) return "none: the log has no poses";
  const auto path = run_.path / name;
  const auto num_pixels =
      DrawScene(run_.deployment, record.pose_history.last(), {}, path);
  // Hands and arms are named with a dot, "<hand>.<box>".
  std::string least;
  int least_pixels = 0;
  for (const body_pose_t& body : record.pose_history.last().bodies) {
    if (body.name.find('.') != std::string::npos) continue;
    const auto it = num_pixels.find(body.name);
    const int num = it == num_pixels.end() ? 0 : it->second;
    if (!least.empty() && num >= least_pixels) continue;
    least = body.name;
    least_pixels = num;
  }
  return fmt::format("{} (least visible: {}, {})", path.string(),
                     Printable(least), Counted(least_pixels, "pixel"));
}

void RunReport::Print(const std::string& line) {
  progress_.Clear();
  (is_hash_ ? std::cerr : std::cout) << line << std::endl;
}

int RunReport::Finish() {
  Follow();
  progress_.Clear();
  const auto& records = observer_.records();
  const bool is_good = records.back().has_ended &&
                       std::ranges::none_of(records, HasWaitedInVain);
  const int result = is_good ? 0 : 1;
  if (is_hash_) {
    for (const EpisodeRecord& record : records) {
      if (const auto why = WhyUnattended(record)) std::cerr << *why << "\n";
    }
    for (const std::string& line : digests_.Lines()) std::cout << line << "\n";
    std::cout << std::flush;
    return result;
  }
  const auto success = SuccessCriterion::Load(run_.deployment);
  int number = 0;
  for (const EpisodeRecord& record : records) {
    std::cout << fmt::format("\nepisode {}, {}:\n", ++number,
                             Printable(record.episode.demonstration));
    std::cout << (record.episode.agent == "robot"
                      ? SummarizeExecuted(record, success)
                      : SummarizeWatched(record))
              << "\n";
    std::cout << "picture "
              << DrawPicture(record, fmt::format("episode-{}.png", number))
              << "\n";
  }
  const double elapsed = progress_.ElapsedSeconds();
  std::cout << fmt::format(
      "\n{:.1f} s simulated in {:.1f} s: {:.1f} x real time\n",
      SimSeconds(tick_), elapsed, SimSeconds(tick_) / elapsed);
  std::cout << "log     " << (run_.path / "cell-0001.lcmlog").string()
            << std::endl;
  return result;
}

}  // namespace cell::cli
