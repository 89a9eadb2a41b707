// Clock and services over real LCM, each on its own thread, in a private
// network, against the same cell in one process.
#include <gmock/gmock.h>

#include <atomic>
#include <map>
#include <mutex>
#include <thread>

#include "common/bus/bus_error.h"
#include "common/bus/lcm_clock.h"
#include "common/bus/lcm_node.h"
#include "common/bus/manifest.h"
#include "common/bus/private_network.h"
#include "common/bus/sim_bus.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

using toy::ToyFactories;
using toy::ToyRoster;

constexpr int32_t kNumTicks = 400;

class LcmLockstep : public testing::Test {
 protected:
  static void SetUpTestSuite() { EnterPrivateNetwork(); }
};

std::vector<int64_t> DigestsInOneProcess() {
  SimBus bus(ToyRoster(), ToyFactories(kNumTicks));
  std::vector<int64_t> digests;
  while (bus.Step()) digests.push_back(TickMessage(bus.last_tick()).digest);
  return digests;
}

// Listens like any LCM tool.
class Listener {
 public:
  explicit Listener(const LcmAddress& address) : port_(address.MainUrl()) {
    port_.Subscribe("TICK", [this](const std::string&, Bytes bytes) {
      tick_t tick{};
      const int size = static_cast<int>(bytes.size());
      ASSERT_EQ(tick.decode(bytes.data(), 0, size), size);
      digests_.emplace(tick.header.tick, TickMessage(tick).digest);
    });
  }
  void Listen() {
    WaitForAny({&port_}, 5);
    port_.Drain();
  }
  /// All TICKs that were received are the expected ones, and the last is among
  /// them: it proves those before it (previous_digest). Waits for it: on a busy
  /// machine it may still be on its way, and a listener may lose another one.
  void Expect(const std::vector<int64_t>& expected) {
    const auto last = static_cast<int32_t>(expected.size()) - 1;
    for (int i = 0; i < kMaxListens && !digests_.contains(last); ++i) Listen();
    ASSERT_TRUE(digests_.contains(last)) << digests_.size() << " TICKs";
    for (const auto& [tick, digest] : digests_) {
      ASSERT_LT(tick, static_cast<int32_t>(expected.size()));
      EXPECT_EQ(digest, expected[static_cast<size_t>(tick)]) << tick;
    }
  }

 private:
  static constexpr int kMaxListens = 4000;  // of 5 ms
  LcmPort port_;
  std::map<int32_t, int64_t> digests_;  // by tick
};

// The toy cell over LCM; what its threads threw.
class Cell {
 public:
  explicit Cell(LcmAddress address, double giveup_s = 30)
      : address_(address), giveup_s_(giveup_s) {}
  ~Cell() {
    stop_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  void StartService(const std::string& name) {
    threads_.emplace_back([this, name] {
      Guard([&] {
        RunLcmNode(address_, ToyRoster(), name,
                   ToyFactories(kNumTicks).at(name), {}, stop_);
      });
    });
  }
  void StartClock() {
    threads_.emplace_back([this] {
      Guard([&] {
        RunLcmClock(address_, ToyRoster(), ToyFactories(kNumTicks).at("source"),
                    {.giveup_s = giveup_s_}, {}, stop_);
      });
      is_clock_done_ = true;
    });
  }
  bool is_clock_done() const { return is_clock_done_; }
  std::string failure() {
    const std::lock_guard lock(mutex_);
    return failure_;
  }

 private:
  template <class F>
  void Guard(F f) {
    try {
      f();
    } catch (const std::exception& e) {
      const std::lock_guard lock(mutex_);
      failure_ += std::string(e.what()) + "\n";
      stop_ = true;
    }
  }

  LcmAddress address_;
  double giveup_s_;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> is_clock_done_ = false;
  std::mutex mutex_;
  std::string failure_;
  std::vector<std::thread> threads_;
};

TEST_F(LcmLockstep, GivesTheSameBytesAsOneProcessInAnyStartOrder) {
  const auto expected = DigestsInOneProcess();
  for (const bool is_clock_first : {true, false}) {
    const LcmAddress address{.port = is_clock_first ? 7701 : 7711};
    Listener listener(address);
    Cell cell(address);
    if (is_clock_first) cell.StartClock();
    cell.StartService("second");
    cell.StartService("third");
    cell.StartService("first");
    if (!is_clock_first) cell.StartClock();
    while (!cell.is_clock_done()) listener.Listen();
    EXPECT_EQ(cell.failure(), "");
    listener.Expect(expected);
  }
}

TEST_F(LcmLockstep, ForgedDatagramsAreIgnored) {
  const auto expected = DigestsInOneProcess();
  const LcmAddress address{.port = 7721};
  Listener listener(address);
  LcmPort forger(address.MainUrl());
  LcmPort control_forger(address.ControlUrl());
  Cell cell(address);
  cell.StartService("first");
  cell.StartService("second");
  cell.StartService("third");
  cell.StartClock();
  Bytes forged = Bus::Encode(toy::Number(0, 4711));
  int32_t seq = 0;
  while (!cell.is_clock_done()) {
    WriteIdentity(seq, 0, seq, forged);
    forger.Publish("SOURCE", forged);
    forger.Publish("DOUBLE", Bytes(3, 0xff));
    control_forger.Publish("ACK", Bytes(40, 0x7f));
    control_forger.Publish("HELLO", Bytes(8, 0));
    seq = (seq + 1) % kNumTicks;
    listener.Listen();
  }
  EXPECT_EQ(cell.failure(), "");
  listener.Expect(expected);
}

TEST_F(LcmLockstep, TwoCellsOnOnePortSayWhatToDo) {
  const LcmAddress address{.port = 7731};
  // Whichever is left without services gives up.
  Cell one(address, 3);
  Cell two(address, 3);
  for (Cell* cell : {&one, &two}) {
    cell->StartService("first");
    cell->StartService("second");
    cell->StartService("third");
    cell->StartClock();
  }
  Listener listener(address);
  while (!one.is_clock_done() || !two.is_clock_done()) listener.Listen();
  EXPECT_THAT(one.failure() + two.failure(),
              testing::HasSubstr("its own port"));
}

TEST_F(LcmLockstep, AMissingServiceIsNamedWhenTheClockGivesUp) {
  const LcmAddress address{.port = 7741};
  std::atomic<bool> stop = false;
  try {
    RunLcmClock(address, ToyRoster(), ToyFactories(9).at("source"),
                {.giveup_s = 0.2}, {}, stop);
    FAIL() << "the clock did not give up";
  } catch (const BusError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("HELLO of first, second, third"));
  }
}

TEST(LcmAddress, RefusesWhatItCannotUse) {
  EXPECT_THROW(LcmAddress::Parse("udpm://239.255.76.67"),
               std::invalid_argument);
  EXPECT_THROW(LcmAddress::Parse("udpm://239.255.76.67:80"),
               std::invalid_argument);
  EXPECT_EQ(LcmAddress::Parse("udpm://239.255.76.67:7700?ttl=1").ttl, 1);
}

}  // namespace
}  // namespace cell
