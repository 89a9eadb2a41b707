// What a tick costs the service that moves an arm, in processor time of its
// thread while ways are planned elsewhere, and how late a loop at the
// UR5's 125 Hz by the wall clock is with it, idle and under load; beside the
// same loop with nothing to do. Example: arm_loop_bench
#include <time.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/bus/sim_bus.h"
#include "common/bus/stepper.h"
#include "common/node/cell_files.h"
#include "services/cell/running/service_registry.h"
#include "tests/bench/figure.h"

namespace cell {

using namespace cli;
namespace {

constexpr uint64_t kSeed = 500;
constexpr char kScript[] = "execution", kArm[] = "robot_arm@right";
constexpr int32_t kNumTicks = 6'000;  // of the run whose inputs are taken
constexpr int32_t kFirstLoop = 1'000, kNumLoops = 1'000;  // 8 s
constexpr int64_t kPeriodNs = kTickUs * 1000;

using Inputs = std::vector<std::vector<Message>>;  // by tick

/// The arm's service alone, fed from a run.
class Arm {
 public:
  explicit Arm(const CellFiles& files)
      : stepper_(
            StepperParams(files.roster, files.roster.RequireIndexOf(kArm), 1)),
        service_(
            AllServices(files.deployment, kScript, kSeed).at(kArm)(stepper_)) {}

  bool Wants(const Message& message) const {
    return stepper_.Wants(message.channel);
  }
  void Tick(int32_t tick, const std::vector<Message>& inputs) {
    if (stepper_.Accept(tick, inputs) == Stepper::State::kReady) stepper_.Run();
  }

 private:
  Stepper stepper_;
  std::unique_ptr<Service> service_;
};

Inputs TakeInputs(const CellFiles& files) {
  const Arm arm(files);
  Roster roster = files.roster;
  std::erase_if(roster.entries,
                [](const auto& entry) { return entry.name == "recorder"; });
  SimBus bus(roster, AllServices(files.deployment, kScript, kSeed));
  Inputs inputs;
  while (static_cast<int32_t>(inputs.size()) < kNumTicks && bus.Step()) {
    auto& wanted = inputs.emplace_back();
    for (const Message& message : bus.last_messages()) {
      if (arm.Wants(message)) wanted.push_back(message);
    }
    std::sort(wanted.begin(), wanted.end(), OrderedBefore);
  }
  return inputs;
}

int64_t NowNs(clockid_t clock = CLOCK_MONOTONIC) {
  timespec now{};
  clock_gettime(clock, &now);
  return now.tv_sec * 1'000'000'000 + now.tv_nsec;
}

void SleepUntil(int64_t ns) {
  const timespec until{ns / 1'000'000'000, ns % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) !=
         0) {
  }
}

/// The time that this share of the samples stays below.
double QuantileUs(std::vector<int64_t> ns, double share) {
  std::sort(ns.begin(), ns.end());
  return 1e-3 * static_cast<double>(ns[static_cast<size_t>(
                    share * static_cast<double>(ns.size() - 1))]);
}

void TimeSteps(const CellFiles& files, const Inputs& inputs) {
  Arm arm(files);
  std::vector<int64_t> steps;
  for (int32_t tick = 0; tick < static_cast<int32_t>(inputs.size()); ++tick) {
    const int64_t start = NowNs(CLOCK_THREAD_CPUTIME_ID);
    arm.Tick(tick, inputs[static_cast<size_t>(tick)]);
    steps.push_back(NowNs(CLOCK_THREAD_CPUTIME_ID) - start);
  }
  const std::string name = "tick of an arm, processor time, ";
  PrintFigure({name + "median", QuantileUs(steps, 0.5), "us", false,
               "a tick in real time", kTickUs});
  PrintFigure({name + "99 %", QuantileUs(steps, 0.99), "us", false,
               "a tick in real time", kTickUs});
}

/// How long after its time each set-point is there.
template <class Work>
std::vector<int64_t> Loop(Work work) {
  std::vector<int64_t> late;
  const int64_t begin = NowNs() + kPeriodNs;
  for (int32_t i = 0; i < kNumLoops; ++i) {
    const int64_t due = begin + i * kPeriodNs;
    SleepUntil(due);
    work(kFirstLoop + i);
    late.push_back(NowNs() - due);
  }
  return late;
}

void LoopBoth(const CellFiles& files, const Inputs& inputs,
              const std::string& how) {
  const auto nothing = Loop([](int32_t) {});
  Arm arm(files);
  for (int32_t tick = 0; tick < kFirstLoop; ++tick) {
    arm.Tick(tick, inputs[static_cast<size_t>(tick)]);
  }
  const auto late = Loop(
      [&](int32_t tick) { arm.Tick(tick, inputs[static_cast<size_t>(tick)]); });
  for (const auto& [share, words] :
       {std::pair{0.5, "median"}, {0.99, "99 %"}, {0.999, "99.9 %"}}) {
    PrintFigure(
        {"lateness of a loop at 125 Hz with an arm, " + how + ", " + words,
         QuantileUs(late, share), "us", false, "the same loop, empty",
         QuantileUs(nothing, share)});
  }
}

int Main() {
  const CellFiles files = FindCellFiles("");
  const Inputs inputs = TakeInputs(files);
  TimeSteps(files, inputs);
  LoopBoth(files, inputs, "idle");
  std::atomic<uint64_t> sink = 0;
  std::vector<std::jthread> load;
  for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) {
    load.emplace_back([&sink](const std::stop_token& stop) {
      while (!stop.stop_requested()) ++sink;
    });
  }
  LoopBoth(files, inputs, "busy");
  return 0;
}

}  // namespace
}  // namespace cell

int main() {
  try {
    return cell::Main();
  } catch (const std::exception& e) {
    std::cerr << "arm_loop_bench: " << e.what() << std::endl;
    return 1;
  }
}
