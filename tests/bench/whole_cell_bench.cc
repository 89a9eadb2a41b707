// The whole cell while the arms work, beside bare mj_step of the same ticks in
// the same run, with all bodies awake.
// Example: whole_cell_bench SCRATCH_DIR DEPLOY_DIR 3 without_cameras
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>

#include "common/bus/run_log.h"
#include "common/node/cell_files.h"
#include "services/cell/running/run_folder.h"
#include "tests/bench/figure.h"
#include "tests/bench/measured_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;

constexpr int32_t kNumTicks = 6000;         // 48 s
constexpr int32_t kNumTicksCameras = 1000;  // rendering takes most of it
constexpr double kGoalOverLcm = 0.75, kGoalInOneProcess = 1.4, kGoalMb = 160;

/// A copy of the deployment in which no body ever sleeps.
fs::path KeptAwake(const fs::path& deploy, const fs::path& scratch) {
  const fs::path copy = scratch / "awake";
  fs::copy(deploy, copy, fs::copy_options::recursive);
  const fs::path file = copy / "config" / "vtb.yaml";
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::ofstream(file) << std::regex_replace(
      text.str(), std::regex("(^|\n)sleep: true"), "$1sleep: false");
  return copy;
}

/// Costs that grow with nothing but what disturbs them: the least counts.
void KeepLeast(const Cost& cost, Cost& least) {
  if (least.num_ticks == 0) least = cost;
  least.wall_s = std::min(least.wall_s, cost.wall_s);
  least.cpu_s = std::min(least.cpu_s, cost.cpu_s);
  least.step_s = std::min(least.step_s, cost.step_s);
  least.resident_mb = std::max(least.resident_mb, cost.resident_mb);
}

double PerTickUs(const Cost& cost, double seconds) {
  return 1e6 * seconds / cost.num_ticks;
}

class WholeCell {
 public:
  WholeCell(fs::path scratch, fs::path deploy)
      : scratch_(std::move(scratch)),
        deploy_(std::move(deploy)),
        files_(FindCellFiles(deploy_.string())),
        awake_(FindCellFiles(KeptAwake(deploy_, scratch_).string())) {}

  /// One after the other, so that a busy time of the machine meets all of them.
  void Measure() {
    const fs::path round = scratch_ / std::to_string(num_rounds_++);
    Deployment recorded = files_.deployment;
    recorded.run_dir = round / "sim";
    fs::create_directories(recorded.run_dir);
    KeepLeast(RunInOneProcess(awake_.roster, awake_.deployment, kNumTicks),
              bare_);
    KeepLeast(RunInOneProcess(files_.roster, recorded, kNumTicks), sim_);
    KeepLeast(ReplayTestbed(files_.roster, recorded), testbed_);
    KeepLeast(RunOverLcm(round / "lcm", deploy_.string(), {}, kNumTicks), lcm_);
    log_mb_ = LogMegabytes(recorded.run_dir);
  }

  void MeasureCameras() {
    cli::RunFolder seeing = cli::RunFolder::Create(
        (scratch_ / "sim-cameras").string(), "", files_.deployment,
        kMeasuredScript, kMeasuredSeed);
    seeing.EnableServices("cameras");
    KeepLeast(
        RunInOneProcess(seeing.roster, seeing.deployment, kNumTicksCameras),
        sim_cameras_);
    KeepLeast(RunOverLcm(scratch_ / "lcm-cameras", deploy_.string(),
                         {"--cameras"}, kNumTicksCameras),
              lcm_cameras_);
  }

  void Print(const std::string& of) const {
    PrintSpeed("testbed alone" + of, testbed_, testbed_.cpu_s);
    PrintSpeed("whole cell, one process" + of, sim_, sim_.cpu_s,
               kGoalInOneProcess);
    PrintSpeed("whole cell, over LCM" + of, lcm_, lcm_.wall_s, kGoalOverLcm);
    PrintFigure({"processor time, one process" + of,
                 PerTickUs(sim_, sim_.cpu_s), "us/tick", false, "bare mj_step",
                 BareUs()});
    PrintFigure({"processor time, over LCM" + of, PerTickUs(lcm_, lcm_.cpu_s),
                 "us/tick", false, "one process", PerTickUs(sim_, sim_.cpu_s)});
    PrintFigure({"memory, one process" + of, sim_.resident_mb, "MB", false, "",
                 0, kGoalMb});
    PrintFigure({"memory, all processes" + of, lcm_.resident_mb, "MB", false,
                 "one process", sim_.resident_mb});
    PrintFigure(
        {"log" + of, log_mb_ * 60 / (0.008 * sim_.num_ticks), "MB/min"});
    if (sim_cameras_.num_ticks == 0) return;
    PrintSpeed("whole cell with cameras, one process" + of, sim_cameras_,
               sim_cameras_.cpu_s);
    PrintSpeed("whole cell with cameras, over LCM" + of, lcm_cameras_,
               lcm_cameras_.wall_s);
  }

 private:
  double BareUs() const { return PerTickUs(bare_, bare_.step_s); }

  static double LogMegabytes(const fs::path& run) {
    double bytes = 0;
    for (const auto& log : LogsOf(run)) {
      bytes += static_cast<double>(fs::file_size(log));
    }
    return 1e-6 * bytes;
  }

  /// The ratio is that of speeds: of one process, whose one thread does all, in
  /// its processor time, which does not depend on what else runs; of several
  /// by the wall clock, which wants a machine that does nothing else.
  void PrintSpeed(const std::string& name, const Cost& cost, double seconds,
                  double goal = 0) const {
    PrintFigure({name, 1e6 / PerTickUs(cost, seconds), "ticks/s", true,
                 "bare mj_step, all awake", 1e6 / BareUs(), goal});
  }

  fs::path scratch_, deploy_;
  CellFiles files_, awake_;
  int num_rounds_ = 0;
  Cost bare_, testbed_, sim_, lcm_, sim_cameras_, lcm_cameras_;
  double log_mb_ = 0;
};

int Main(const std::vector<std::string>& arguments) {
  const std::string& deploy = arguments[1];
  WholeCell cell(arguments[0], deploy);
  for (int i = std::stoi(arguments[2]); i > 0; --i) cell.Measure();
  if (arguments[3] == "with_cameras") cell.MeasureCameras();
  cell.Print(arguments.size() > 4 ? " " + arguments[4] : "");
  return 0;
}

}  // namespace
}  // namespace cell

int main(int argc, char** argv) {
  if (argc != 5 && argc != 6) {
    std::cerr << "usage: whole_cell_bench SCRATCH_DIR DEPLOY_DIR ROUNDS "
                 "with_cameras|without_cameras [NAME]\n";
    return 2;
  }
  try {
    return cell::Main({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    std::cerr << "whole_cell_bench: " << e.what() << std::endl;
    return 1;
  }
}
