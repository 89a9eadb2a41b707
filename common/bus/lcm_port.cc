#include "common/bus/lcm_port.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netinet/in.h>
#include <poll.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <random>
#include <regex>
#include <stdexcept>
#include <utility>

#include "common/bus/bus_error.h"
#include "common/bus/channel_filter.h"
#include "common/config/decimal.h"

namespace cell {
namespace {

// liblcm opens its receiving socket at the first subscription and does not
// return it: hence one port at a time.
std::recursive_mutex& OpeningSocket() {
  static std::recursive_mutex mutex;
  return mutex;
}

bool IsMulticast(const std::string& group) {
  in_addr address{};
  return inet_pton(AF_INET, group.c_str(), &address) == 1 &&
         IN_MULTICAST(ntohl(address.s_addr));
}

}  // namespace

LcmAddress LcmAddress::Parse(const std::string& url) {
  static const std::regex kForm(
      R"(udpm://([0-9.]+):([0-9]{1,5})(\?ttl=([0-9]{1,3}))?)");
  std::smatch match;
  LcmAddress address;
  if (!std::regex_match(url, match, kForm)) {
    throw std::invalid_argument("'" + url +
                                "' is not of the form "
                                "udpm://239.255.76.67:7667[?ttl=0]");
  }
  address.group = match[1];
  if (!IsMulticast(address.group)) {
    throw std::invalid_argument("'" + url +
                                "': the group must be a multicast address, "
                                "224.0.0.0 to 239.255.255.255");
  }
  const auto port = ParseDecimal<int>(match[2].str());
  if (!port || *port < 1024 || *port > 65534) {
    throw std::invalid_argument("'" + url +
                                "': the port and the next one must lie in "
                                "[1024, 65535]");
  }
  address.port = *port;
  if (!match[4].matched) return address;
  const auto ttl = ParseDecimal<int>(match[4].str());
  if (!ttl || *ttl > 255) {
    throw std::invalid_argument("'" + url + "': ttl must lie in [0, 255]");
  }
  address.ttl = *ttl;
  return address;
}

std::string LcmAddress::Url(int of_port) const {
  // The default receive buffer loses every message of 300 KB.
  return fmt::format("udpm://{}:{}?ttl={}&recv_buf_size=4194304", group,
                     of_port, ttl);
}

LcmPort::LcmPort(const std::string& url)
    : port_(std::atoi(url.c_str() + url.rfind(':') + 1)), lcm_(url) {
  if (!lcm_.good()) {
    throw BusError(
        "cannot open LCM at " + url +
        ". Usually a multicast route is missing: ip link set lo up && "
        "ip route add 224.0.0.0/4 dev lo");
  }
}

void LcmPort::Subscribe(const std::string& pattern, Handler handler) {
  const std::lock_guard lock(OpeningSocket());
  subscriptions_.push_back({std::move(handler), nullptr});
  lcm::Subscription* subscription = lcm_.subscribeFunction(
      pattern, &LcmPort::OnMessage, &subscriptions_.back());
  if (subscription == nullptr) {
    throw BusError("cannot subscribe to " + pattern +
                   ": no receiving socket; is there a multicast route? "
                   "(ip route add 224.0.0.0/4 dev lo)");
  }
  subscription->setQueueCapacity(0);
}

void LcmPort::SubscribeTo(const Channels& channels, Handler handler) {
  if (!subscriptions_.empty()) {
    throw std::logic_error("a port that has subscribed cannot be filtered");
  }
  if (!channels) return Subscribe(".*", std::move(handler));
  const std::lock_guard lock(OpeningSocket());
  const std::vector<int> others = SocketsOn(port_);
  Subscribe(fmt::format("({})", fmt::join(*channels, "|")), std::move(handler));
  for (const int socket : SocketsOn(port_)) {
    if (std::binary_search(others.begin(), others.end(), socket)) continue;
    AttachFilter(socket, ChannelFilter(*channels));
  }
}

void LcmPort::Publish(const std::string& channel, const Bytes& bytes) {
  if (lcm_.publish(channel, bytes.data(),
                   static_cast<unsigned>(bytes.size())) != 0) {
    throw BusError("LCM cannot publish on " + channel +
                   "; is there a multicast route? (ip route add "
                   "224.0.0.0/4 dev lo)");
  }
}

void LcmPort::Drain() {
  // A signal interrupts the wait inside liblcm: then there is just no more.
  while (lcm_.handleTimeout(0) > 0) {
    for (Subscription& subscription : subscriptions_) {
      if (subscription.failure) {
        std::rethrow_exception(std::exchange(subscription.failure, nullptr));
      }
    }
  }
}

void LcmPort::OnMessage(const lcm::ReceiveBuffer* buffer,
                        const std::string& channel,
                        Subscription* subscription) {
  // A channel name without its NUL arrives with a size of 2^32 - 1; LCM
  // assembles no message of more than 2^28.
  constexpr uint32_t kMaxSize = 1u << 28;
  if (buffer->data_size > kMaxSize) return;
  const auto* data = static_cast<const uint8_t*>(buffer->data);
  try {
    subscription->handler(channel, Bytes(data, data + buffer->data_size));
  } catch (const std::exception&) {
    subscription->failure = std::current_exception();
  }
}

int64_t RandomIdentity() {
  std::random_device device;
  return static_cast<int64_t>((uint64_t{device()} << 31) ^ device()) | 1;
}

void WaitForAny(const std::vector<LcmPort*>& ports, int timeout_ms) {
  std::vector<pollfd> descriptors;
  for (LcmPort* port : ports) {
    descriptors.push_back({port->FileDescriptor(), POLLIN, 0});
  }
  poll(descriptors.data(), descriptors.size(), timeout_ms);
}

}  // namespace cell
