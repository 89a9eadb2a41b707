#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/decode.h"

namespace cell {

/// Length of a tick of the cell's clock: the UR5's servo period (125 Hz).
inline constexpr int64_t kTickUs = 8'000;

/// Every message of the type has a header_t as its first field.
template <class M>
concept BusMessage = requires(M message) {
  { message.header.utime } -> std::convertible_to<int64_t>;
  { message.getEncodedSize() } -> std::convertible_to<int>;
};

/// The one seam between a service and the world. A service sees messages and
/// timers one at a time, in an order that does not depend on how it is fed
/// (LCM, one process, a log); time is data.
class Bus {
 public:
  /// Returns false if the bytes cannot be used: they are counted as rejected.
  using BytesHandler = std::function<bool(std::span<const uint8_t>)>;
  /// For services that take whatever comes, like a recorder.
  using AnyHandler =
      std::function<void(const std::string& channel, std::span<const uint8_t>)>;
  /// All messages of a tick reach the handler.
  static constexpr size_t kAll = 0;

  Bus() = default;
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;
  virtual ~Bus() = default;

  /// `handler` gets at most the newest `depth` messages of a tick (kAll: every
  /// one). One subscription per channel.
  /// @throws std::logic_error for a second one, or for TRUTH_* by a service
  /// that has no right to it (truth_access.h).
  virtual void SubscribeBytes(const std::string& channel, size_t depth,
                              BytesHandler handler) = 0;

  /// Every message of the run, the clock's TICK among them.
  virtual void SubscribeAll(AnyHandler handler) = 0;

  /// Publishes an encoded message; the bus writes tick, sender and seq into its
  /// header. Only from within a handler or a timer.
  virtual void PublishBytes(const std::string& channel,
                            std::vector<uint8_t> bytes) = 0;

  /// Calls `timer` in every tick with tick % period_ticks == phase, after the
  /// tick's messages. A service with a latency of more than a tick is not woken
  /// by timers: those that fell due run with its next message.
  virtual void Every(int32_t period_ticks, int32_t phase,
                     std::function<void()> timer) = 0;

  /// [us since the start of the run], constant within a tick.
  virtual int64_t now() const = 0;
  virtual int32_t tick() const = 0;

  /// The clock ends the run so many ticks from now. Means something only for
  /// the service that owns time.
  virtual void EndRunIn(int32_t ticks) = 0;

  /// Calls `handler` with every message on `channel` that decodes as M; others
  /// (forged, truncated, of other lcmtypes) are rejected and counted. A handler
  /// that returns bool rejects a message by returning false.
  template <BusMessage M, class Handler>
  void Subscribe(const std::string& channel, Handler handler,
                 size_t depth = kAll) {
    SubscribeBytes(
        channel, depth,
        [handler = std::move(handler)](std::span<const uint8_t> bytes) {
          const auto message = Decode<M>(bytes);
          if (!message) return false;
          if constexpr (std::same_as<std::invoke_result_t<Handler, const M&>,
                                     bool>) {
            return handler(*message);
          } else {
            handler(*message);
            return true;
          }
        });
  }

  template <BusMessage M>
  void Publish(const std::string& channel, const M& message) {
    PublishBytes(channel, Encode(message));
  }

  template <class M>
  static std::vector<uint8_t> Encode(const M& message) {
    std::vector<uint8_t> bytes(static_cast<size_t>(message.getEncodedSize()));
    message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    return bytes;
  }
};

/// What one process runs on a bus. The constructor of a service takes
/// (Bus&, Params) and subscribes; the object exists while the service runs.
class Service {
 public:
  Service() = default;
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;
  virtual ~Service() = default;
};

}  // namespace cell
