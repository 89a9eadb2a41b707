#include "common/bus/lcm_receiver.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "common/bus/bus_error.h"
#include "common/bus/channel_filter.h"

namespace cell {
namespace {

constexpr int kReceiveBuffer = 4 << 20;  // [bytes], as LcmPort asks of liblcm

PacketAssembler::Wants Among(const Channels& channels) {
  return [channels](const std::string& channel) {
    return !channels || std::ranges::count(*channels, channel) > 0;
  };
}

bool Set(int socket, int level, int option, int value) {
  return setsockopt(socket, level, option, &value, sizeof(value)) == 0;
}

/// The port of this group only: packets of other groups on the port belong to
/// other cells.
bool Join(int socket, const std::string& group, int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  ip_mreq membership{};
  inet_pton(AF_INET, group.c_str(), &address.sin_addr);
  membership.imr_multiaddr = address.sin_addr;
  return Set(socket, SOL_SOCKET, SO_REUSEADDR, 1) &&
         Set(socket, SOL_SOCKET, SO_RCVBUF, kReceiveBuffer) &&
         bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof(address)) ==
             0 &&
         setsockopt(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership,
                    sizeof(membership)) == 0;
}

uint64_t IdOf(const sockaddr_in& address) {
  return uint64_t{address.sin_addr.s_addr} << 16 | address.sin_port;
}

}  // namespace

void LcmReceiver::Closer::operator()(const int* descriptor) const {
  close(*descriptor);
  delete descriptor;
}

LcmReceiver::LcmReceiver(const std::string& group, int port,
                         const Channels& channels, Handler handler)
    : socket_(new int(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0))),
      assembler_(Among(channels)),
      handler_(std::move(handler)),
      packets_(
          std::make_unique_for_overwrite<uint8_t[]>(kNumPackets * kMaxPacket)) {
  // Set before the socket joins the group, so that no other packet gets in. A
  // filter that the kernel refuses costs time only.
  if (channels) AttachFilter(*socket_, ChannelFilter(*channels));
  if (!Join(*socket_, group, port)) {
    throw BusError(fmt::format(
        "cannot receive on {}:{}: {}. Usually a multicast route is missing: ip "
        "link set lo up && ip route add 224.0.0.0/4 dev lo",
        group, port, std::strerror(errno)));
  }
}

void LcmReceiver::Drain() {
  std::array<mmsghdr, kNumPackets> headers{};
  std::array<iovec, kNumPackets> buffers{};
  std::array<sockaddr_in, kNumPackets> senders{};
  for (size_t i = 0; i < kNumPackets; ++i) {
    buffers[i] = {&packets_[i * kMaxPacket], kMaxPacket};
    headers[i].msg_hdr.msg_iov = &buffers[i];
    headers[i].msg_hdr.msg_iovlen = 1;
    headers[i].msg_hdr.msg_name = &senders[i];
  }
  for (int num = kNumPackets; num == kNumPackets;) {
    for (mmsghdr& header : headers) {
      header.msg_hdr.msg_namelen = sizeof(sockaddr_in);
    }
    num =
        recvmmsg(*socket_, headers.data(), kNumPackets, MSG_DONTWAIT, nullptr);
    for (int i = 0; i < num; ++i) {
      const auto k = static_cast<size_t>(i);
      auto arrival = assembler_.Put(
          IdOf(senders[k]), {&packets_[k * kMaxPacket], headers[k].msg_len});
      if (arrival) handler_(arrival->channel, std::move(arrival->bytes));
    }
  }
}

void WaitForAny(const std::vector<const LcmReceiver*>& receivers,
                int timeout_ms) {
  std::vector<pollfd> descriptors;
  for (const LcmReceiver* receiver : receivers) {
    descriptors.push_back({receiver->FileDescriptor(), POLLIN, 0});
  }
  poll(descriptors.data(), descriptors.size(), timeout_ms);
}

}  // namespace cell
