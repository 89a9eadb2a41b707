#include "common/bus/channel_filter.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "common/bus/lcm_packet.h"

namespace cell {
namespace {

// A packet as the filter of a UDP socket sees it: UDP's header, then LCM's
// magic and sequence number, then the channel's name with its NUL.
constexpr uint32_t kMagicOffset = 8;
constexpr uint32_t kChannelOffset = kMagicOffset + kShortHeaderSize;
constexpr uint32_t kDrop = 0;
constexpr uint32_t kKeep = 0xffffffff;

sock_filter Load(size_t size, size_t offset) {
  const int width = size == 4 ? BPF_W : size == 2 ? BPF_H : BPF_B;
  return BPF_STMT(static_cast<uint16_t>(BPF_LD | BPF_ABS | width),
                  static_cast<uint32_t>(kChannelOffset + offset));
}

sock_filter JumpUnless(uint32_t value, size_t skip) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0,
                  static_cast<uint8_t>(skip));
}

sock_filter Return(uint32_t verdict) {
  return BPF_STMT(BPF_RET | BPF_K, verdict);
}

/// Compares the name and its NUL, 4, 2 and 1 bytes at a time.
void AppendChannel(const std::string& channel,
                   std::vector<sock_filter>& program) {
  const size_t length = channel.size() + 1;
  struct Word {
    size_t offset, size;
    uint32_t value = 0;
  };
  std::vector<Word> words;
  for (size_t offset = 0; offset < length;) {
    const size_t left = length - offset;
    Word word{offset, left >= 4 ? 4u : left >= 2 ? 2u : 1u};
    for (size_t i = 0; i < word.size; ++i) {
      const size_t at = offset + i;
      const auto byte =
          at < channel.size() ? static_cast<uint8_t>(channel[at]) : uint8_t{0};
      word.value = word.value << 8 | byte;
    }
    words.push_back(word);
    offset += word.size;
  }
  for (size_t i = 0; i < words.size(); ++i) {
    const size_t num_left = 2 * (words.size() - i) - 1;  // the return too
    program.push_back(Load(words[i].size, words[i].offset));
    program.push_back(JumpUnless(words[i].value, num_left));
  }
  program.push_back(Return(kKeep));
}

}  // namespace

std::vector<sock_filter> ChannelFilter(std::vector<std::string> channels) {
  // A load beyond the packet's end drops it: shorter names come first, so that
  // such a packet could be of no later channel either.
  std::sort(channels.begin(), channels.end(),
            [](const std::string& a, const std::string& b) {
              return a.size() < b.size();
            });
  std::vector<sock_filter> program = {
      BPF_STMT(BPF_LD | BPF_ABS | BPF_W, kMagicOffset),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kShortMagic, 1, 0), Return(kKeep)};
  for (const std::string& channel : channels) AppendChannel(channel, program);
  program.push_back(Return(kDrop));
  if (program.size() > BPF_MAXINSNS) program.clear();
  return program;
}

std::vector<int> SocketsOn(int port) {
  std::vector<int> sockets;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const int descriptor = std::atoi(entry.path().filename().c_str());
    sockaddr_in address{};
    socklen_t size = sizeof(address);
    int type = 0;
    socklen_t type_size = sizeof(type);
    if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) ==
            0 &&
        address.sin_family == AF_INET && ntohs(address.sin_port) == port &&
        getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &type_size) == 0 &&
        type == SOCK_DGRAM) {
      sockets.push_back(descriptor);
    }
  }
  std::sort(sockets.begin(), sockets.end());
  return sockets;
}

bool AttachFilter(int socket, std::vector<sock_filter> program) {
  const sock_fprog whole{static_cast<unsigned short>(program.size()),
                         program.data()};
  return !program.empty() && setsockopt(socket, SOL_SOCKET, SO_ATTACH_FILTER,
                                        &whole, sizeof(whole)) == 0;
}

}  // namespace cell
