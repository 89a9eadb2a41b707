// The whole cell beside bare mj_step of the same motions, in the same run.
// Example: whole_cell_bench SCRATCH_DIR [DEPLOY_DIR]
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "common/bus/process_usage.h"
#include "common/bus/replay.h"
#include "common/bus/run_log.h"
#include "common/bus/sim_bus.h"
#include "common/node/cell_files.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/running/service_registry.h"

namespace cell {

using namespace cli;
namespace {

constexpr uint64_t kSeed = 500;
constexpr char kScript[] = "execution";  // the arms work

double Now() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

struct Timing {
  double wall_s = 0;
  double sim_s = 0;
};

Timing Run(const Roster& roster, const Deployment& deployment) {
  SimBus bus(roster, AllServices(deployment, kScript, kSeed));
  const double start = Now();
  while (bus.Step()) {
  }
  return {Now() - start, bus.last_tick().header.tick * kTickUs * 1e-6};
}

// Seconds that mj_step itself took: MuJoCo keeps them in its data as soon as it
// has a clock, and hands the data to this callback in every step.
double g_step_s = 0;

// The testbed alone, given what it was given in the recorded run.
struct Alone {
  double wall_s = 0;
  double step_s = 0;
};

Alone ReplayTestbed(const Roster& roster, const Deployment& recorded) {
  const RunLog log = RunLog::Load(recorded.run_dir.string());
  Deployment deployment = recorded;
  deployment.run_dir.clear();
  mjcb_time = Now;
  mjcb_passive = [](const mjModel*, mjData* data) {
    g_step_s = data->timer[mjTIMER_STEP].duration;
  };
  const double start = Now();
  const ReplayResult result = Replay(
      log, roster, "vtb", AllServices(deployment, kScript, kSeed).at("vtb"));
  if (result.difference) throw std::runtime_error(*result.difference);
  mjcb_time = nullptr;
  mjcb_passive = nullptr;
  return {Now() - start, g_step_s};
}

// The clock's own account of a run over LCM, in the last line that it said.
double LcmSeconds(const std::string& deploy, const std::filesystem::path& run,
                  const char* cameras) {
  const auto bin =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string command = fmt::format(
      "{} demo --hash {} --seed {} --demonstration {} --out {}{} "
      "> /dev/null",
      (bin / "cell").string(), cameras, kSeed, kScript, run.string(),
      deploy.empty() ? "" : " --deploy " + deploy);
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error("cell demo failed; see " + run.string());
  }
  std::ifstream file(run / "vtb.out");
  std::string line;
  std::string last;
  while (std::getline(file, line)) last = line;
  const size_t at = last.find(" ticks in ");
  if (at == std::string::npos) {
    throw std::runtime_error("no tick count in " + (run / "vtb.out").string());
  }
  return std::stod(last.substr(at + 10));
}

double LogMegabytesPerMinute(const std::filesystem::path& run, double sim_s) {
  double bytes = 0;
  for (const auto& log : LogsOf(run)) {
    bytes += static_cast<double>(std::filesystem::file_size(log));
  }
  return bytes * 1e-6 / (sim_s / 60);
}

void Print(const char* what, double wall_s, double sim_s, double bare_s) {
  std::cout << fmt::format(
      "{:34} {:7.2f} s  {:6.1f} x real time  {:5.2f} of "
      "bare mj_step's speed\n",
      what, wall_s, sim_s / wall_s, bare_s / wall_s);
}

int Main(const std::filesystem::path& scratch, const std::string& deploy) {
  const CellFiles files = FindCellFiles(deploy);
  Deployment recorded = files.deployment;
  recorded.run_dir = scratch / "sim";
  std::filesystem::create_directories(recorded.run_dir);
  const Timing sim = Run(files.roster, recorded);
  const Alone alone = ReplayTestbed(files.roster, recorded);
  const double bare_s = alone.step_s;
  RunFolder seeing = RunFolder::Create((scratch / "sim-cameras").string(), "",
                                       files.deployment, kScript, kSeed);
  seeing.EnableServices("cameras");
  const Timing sim_cameras = Run(seeing.roster, seeing.deployment);
  const double lcm_s = LcmSeconds(deploy, scratch / "lcm", "");
  const double lcm_cameras_s =
      LcmSeconds(deploy, scratch / "lcm-cameras", "--cameras");
  Print("bare mj_step", bare_s, sim.sim_s, bare_s);
  Print("vtb alone, replayed", alone.wall_s, sim.sim_s, bare_s);
  Print("whole cell, one process", sim.wall_s, sim.sim_s, bare_s);
  Print("the same with cameras", sim_cameras.wall_s, sim_cameras.sim_s, bare_s);
  Print("whole cell, lockstep over LCM", lcm_s, sim.sim_s, bare_s);
  Print("the same with cameras", lcm_cameras_s, sim.sim_s, bare_s);
  std::cout << fmt::format(
      "log: {:.1f} MB/min, with cameras {:.1f} MB/min\n",
      LogMegabytesPerMinute(scratch / "sim", sim.sim_s),
      LogMegabytesPerMinute(seeing.path, sim_cameras.sim_s));
  std::cout << fmt::format("resident memory of the one process: {} MB\n",
                           UsageOfThisProcess().resident_bytes >> 20);
  return 0;
}

}  // namespace
}  // namespace cell

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: whole_cell_bench SCRATCH_DIR [DEPLOY_DIR]\n";
    return 2;
  }
  try {
    return cell::Main(argv[1], argc == 3 ? argv[2] : "");
  } catch (const std::exception& e) {
    std::cerr << "whole_cell_bench: " << e.what() << std::endl;
    return 1;
  }
}
