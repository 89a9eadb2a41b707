#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/bus/message.h"

namespace cell {

/// Where a cell talks: multicast group and main port; the control port is the
/// next one, so that HELLO, ACK and HEALTH never wake the services.
struct LcmAddress {
  std::string group = "239.255.76.67";
  int port = 7667;
  int ttl = 0;  ///< 0: this host only

  /// @throws std::invalid_argument unless it is udpm://GROUP:PORT[?ttl=N].
  static LcmAddress Parse(const std::string& url);
  std::string MainUrl() const { return Url(port); }
  std::string ControlUrl() const { return Url(port + 1); }

 private:
  std::string Url(int of_port) const;
};

/// A message that is still missing after this long is lost.
inline constexpr std::chrono::seconds kLossTimeout{5};

/// One LCM instance on one port. Handlers run inside Drain(), on its thread;
/// no exception of theirs passes through liblcm's C code.
class LcmPort {
 public:
  using Handler = std::function<void(const std::string& channel, Bytes)>;

  /// @throws BusError that names the fix if there is no multicast route.
  explicit LcmPort(const std::string& url);
  LcmPort(const LcmPort&) = delete;
  LcmPort& operator=(const LcmPort&) = delete;

  /// `pattern` is a regular expression, as in LCM. The queue is unlimited:
  /// the bus drops by tick order, LCM would drop by timing.
  void Subscribe(const std::string& pattern, Handler handler);
  /// Once, instead of Subscribe(): packets of other channels do not even wake
  /// the process.
  void SubscribeTo(const Channels& channels, Handler handler);
  /// @throws BusError naming the channel.
  void Publish(const std::string& channel, const Bytes& bytes);
  /// Handles all that has come. @throws what a handler threw.
  void Drain();
  /// For poll(2): readable when there is something to drain.
  int FileDescriptor() { return lcm_.getFileno(); }

 private:
  struct Subscription {
    Handler handler;
    std::exception_ptr failure;
  };
  static void OnMessage(const lcm::ReceiveBuffer* buffer,
                        const std::string& channel, Subscription* subscription);

  int port_ = 0;
  std::deque<Subscription> subscriptions_;  // liblcm keeps their addresses
  lcm::LCM lcm_;
};

/// Tells one start of a process from all others; never 0.
int64_t RandomIdentity();

/// Waits until one of the ports has something to drain, at most `timeout_ms`;
/// a signal ends the wait.
void WaitForAny(const std::vector<LcmPort*>& ports, int timeout_ms);

}  // namespace cell
