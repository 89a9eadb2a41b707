#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/message.h"
#include "common/bus/packet_assembler.h"

namespace cell {

/// Receives LCM's messages of one multicast group and port on a socket of its
/// own. liblcm receives on a thread of its own and passes each message through
/// a pipe: three system calls and two changes of context for each; here there
/// is neither. What is not drained waits in the socket's buffer, so this is
/// for processes that cannot fall behind: those of a cell in lockstep.
class LcmReceiver {
 public:
  using Handler = std::function<void(const std::string& channel, Bytes)>;

  /// Packets of other channels do not wake the process.
  /// @throws BusError that names the fix if there is no multicast route.
  LcmReceiver(const std::string& group, int port, const Channels& channels,
              Handler handler);

  /// Handles all that has arrived. @throws what the handler throws.
  void Drain();
  /// For poll(2): readable when there is something to drain.
  int FileDescriptor() const { return *socket_; }

 private:
  static constexpr size_t kMaxPacket = 1u << 16, kNumPackets = 8;

  /// A descriptor that is closed with its owner.
  struct Closer {
    void operator()(const int* descriptor) const;
  };

  std::unique_ptr<const int, Closer> socket_;
  PacketAssembler assembler_;
  Handler handler_;
  std::unique_ptr<uint8_t[]> packets_;  // kNumPackets of kMaxPacket
};

/// Waits until one of the receivers has something to drain, at most
/// `timeout_ms`; a signal ends the wait.
void WaitForAny(const std::vector<const LcmReceiver*>& receivers,
                int timeout_ms);

}  // namespace cell
