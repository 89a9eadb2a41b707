// What the bus costs per message, beside raw liblcm in the same run.
#include <benchmark/benchmark.h>

#include <atomic>
#include <lcm/lcm-cpp.hpp>
#include <thread>

#include "common/bus/lcm_clock.h"
#include "common/bus/lcm_node.h"
#include "common/bus/private_network.h"
#include "common/bus/sim_bus.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

constexpr int32_t kNumTicks = 2000;

// One message there and one back between two threads, nothing else.
void RawLcmRoundTrip(benchmark::State& state) {
  const std::string url = "udpm://239.255.76.67:7801?ttl=0";
  lcm::LCM ping(url);
  std::atomic<bool> stop = false;
  std::thread echo([&] {
    lcm::LCM pong(url);
    struct Echo {
      lcm::LCM* lcm;
      void OnPing(const lcm::ReceiveBuffer* buffer, const std::string&) {
        lcm->publish("PONG", buffer->data, buffer->data_size);
      }
    } handler{&pong};
    pong.subscribe("PING", &Echo::OnPing, &handler);
    while (!stop) pong.handleTimeout(20);
  });
  struct Count {
    int num = 0;
    void OnPong(const lcm::ReceiveBuffer*, const std::string&) { ++num; }
  } count;
  ping.subscribe("PONG", &Count::OnPong, &count);
  const Bytes bytes = Bus::Encode(toy::Number(0, 1));
  for (auto _ : state) {
    ping.publish("PING", bytes.data(), static_cast<unsigned>(bytes.size()));
    ping.handleTimeout(100);
  }
  stop = true;
  echo.join();
  state.SetItemsProcessed(2 * count.num);
}
BENCHMARK(RawLcmRoundTrip)->UseRealTime();

// The toy cell over LCM: 3 services and the clock; about 5 data messages, a
// TICK and 3 ACKs a tick. Items are messages.
void LockstepOverLcm(benchmark::State& state) {
  for (auto _ : state) {
    const LcmAddress address{.port = 7811};
    const std::atomic<bool> stop = false;
    std::vector<std::thread> services;
    for (const char* name : {"first", "second", "third"}) {
      services.emplace_back([&, name] {
        RunLcmNode(address, toy::ToyRoster(1), name,
                   toy::ToyFactories(kNumTicks).at(name), {}, stop);
      });
    }
    const auto summary =
        RunLcmClock(address, toy::ToyRoster(1),
                    toy::ToyFactories(kNumTicks).at("source"), {}, {}, stop);
    for (std::thread& service : services) service.join();
    state.SetIterationTime(summary.elapsed_s);
  }
  state.SetItemsProcessed(state.iterations() * kNumTicks * 9);
}
BENCHMARK(LockstepOverLcm)->UseManualTime()->Unit(benchmark::kMillisecond);

// The same cell in one process.
void LockstepInOneProcess(benchmark::State& state) {
  for (auto _ : state) {
    SimBus bus(toy::ToyRoster(1), toy::ToyFactories(kNumTicks));
    while (bus.Step()) {
    }
  }
  state.SetItemsProcessed(state.iterations() * kNumTicks * 9);
}
BENCHMARK(LockstepInOneProcess)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cell

int main(int argc, char** argv) {
  cell::EnterPrivateNetwork();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
