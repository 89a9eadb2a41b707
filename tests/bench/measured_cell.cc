#include "tests/bench/measured_cell.h"

#include <mujoco/mujoco.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "common/bus/process_usage.h"
#include "common/bus/replay.h"
#include "common/bus/run_log.h"
#include "common/bus/sim_bus.h"
#include "services/cell/logs/log_follower.h"
#include "services/cell/running/process_group.h"
#include "services/cell/running/service_registry.h"

namespace cell {
namespace {

using namespace std::chrono_literals;

double Now() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

double ResidentMegabytes() {
  return 1e-6 * static_cast<double>(UsageOfThisProcess().resident_bytes);
}

// Seconds that mj_step itself took: MuJoCo keeps them in its data as soon as it
// has a clock, and hands the data to this callback in every step.
double g_step_s = 0;

class StepTimer {
 public:
  StepTimer() {
    g_step_s = 0;
    mjcb_time = Now;
    mjcb_passive = [](const mjModel*, mjData* data) {
      g_step_s = data->timer[mjTIMER_STEP].duration;
    };
  }
  StepTimer(const StepTimer&) = delete;
  StepTimer& operator=(const StepTimer&) = delete;
  ~StepTimer() {
    mjcb_time = nullptr;
    mjcb_passive = nullptr;
  }
};

/// What this process has done since it was made; one thread.
class StopWatch {
 public:
  Cost Read(int32_t num_ticks) const {
    const double wall_s = Now() - wall_s_, cpu_s = CpuSeconds() - cpu_s_;
    // A clock of processor time would slow mj_step down: its share of the
    // time is measured by the wall clock.
    return {num_ticks, wall_s, cpu_s, g_step_s * cpu_s / wall_s,
            ResidentMegabytes()};
  }

 private:
  StepTimer timer_;
  double wall_s_ = Now(), cpu_s_ = CpuSeconds();
};

/// Adds what a process and its descendants have used so far.
void AddUsage(int pid, Cost& cost) {
  const std::string folder = "/proc/" + std::to_string(pid);
  std::ifstream stat(folder + "/stat");
  std::string word;
  // The name, in brackets, is the second field; of ours none has a space.
  for (int i = 0; i < 13; ++i) stat >> word;
  double user = 0, system = 0;
  stat >> user >> system;
  cost.cpu_s += (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  std::ifstream statm(folder + "/statm");
  double pages = 0;
  statm >> word >> pages;
  cost.resident_mb += 1e-6 * pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  std::ifstream children(folder + "/task/" + std::to_string(pid) + "/children");
  for (int child = 0; children >> child;) AddUsage(child, cost);
}

/// Of all processes that this one has started.
Cost UsageOfChildren() {
  Cost cost;
  std::ifstream children("/proc/self/task/" + std::to_string(getpid()) +
                         "/children");
  for (int child = 0; children >> child;) AddUsage(child, cost);
  return cost;
}

}  // namespace

Cost RunInOneProcess(const Roster& roster, const Deployment& deployment,
                     int32_t num_ticks) {
  SimBus bus(roster,
             cli::AllServices(deployment, kMeasuredScript, kMeasuredSeed));
  const StopWatch watch;
  while (bus.last_tick().header.tick < num_ticks && bus.Step()) {
  }
  return watch.Read(bus.last_tick().header.tick);
}

Cost ReplayTestbed(const Roster& roster, const Deployment& deployment) {
  const RunLog log = RunLog::Load(deployment.run_dir);
  Deployment unrecorded = deployment;
  unrecorded.run_dir.clear();
  const ServiceFactory factory =
      cli::AllServices(unrecorded, kMeasuredScript, kMeasuredSeed)
          .at(roster.entries[0].name);
  const StopWatch watch;
  const ReplayResult result =
      Replay(log, roster, roster.entries[0].name, factory);
  if (result.difference) throw std::runtime_error(*result.difference);
  return watch.Read(log.ticks().rbegin()->first);
}

Cost RunOverLcm(const std::filesystem::path& run, const std::string& deploy,
                const std::vector<std::string>& options, int32_t num_ticks) {
  const auto program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cell";
  std::vector<std::string> arguments = {"demo",
                                        "--hash",
                                        "--seed",
                                        std::to_string(kMeasuredSeed),
                                        "--demonstration",
                                        kMeasuredScript,
                                        "--out",
                                        run.string()};
  if (!deploy.empty()) arguments.insert(arguments.end(), {"--deploy", deploy});
  arguments.insert(arguments.end(), options.begin(), options.end());
  cli::ProcessGroup group;
  group.Start("demo", program, arguments, run.string() + ".out");
  cli::LogFollower log(run);
  double start = 0;
  Cost before;
  int32_t tick = -1;
  while (tick < num_ticks) {
    const auto message = log.Next();
    if (message) {
      if (tick < 0) {
        start = Now();
        before = UsageOfChildren();
      }
      tick = message->tick;
      continue;
    }
    if (!group.TakeDeaths().empty()) {
      throw std::runtime_error("cell demo ended in tick " +
                               std::to_string(tick) + "; see " + run.string() +
                               ".out");
    }
    std::this_thread::sleep_for(2ms);
  }
  Cost cost = UsageOfChildren();
  cost.num_ticks = tick;
  cost.wall_s = Now() - start;
  cost.cpu_s -= before.cpu_s;
  group.StopAll(5000);
  return cost;
}

}  // namespace cell
