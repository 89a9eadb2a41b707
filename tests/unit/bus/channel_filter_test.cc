#include "common/bus/channel_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace cell {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

// Two sockets of which one filters as a UDP socket would: what comes before
// LCM's own bytes stands for UDP's header.
class ChannelFilterTest : public testing::Test {
 protected:
  ChannelFilterTest() {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0, ends_.data()),
              0);
  }
  ~ChannelFilterTest() override {
    for (const int end : ends_) close(end);
  }

  static std::string Packet(const std::string& magic,
                            const std::string& channel, size_t size = 28) {
    return std::string(8, 'u') + magic + "seqn" + channel + '\0' +
           std::string(size, 'x');
  }

  bool Passes(const std::string& packet) {
    EXPECT_NE(send(ends_[0], packet.data(), packet.size(), 0), -1);
    std::array<char, 1000> buffer;
    const auto size = recv(ends_[1], buffer.data(), buffer.size(), 0);
    if (size < 0) return false;
    EXPECT_EQ(std::string(buffer.data(), static_cast<size_t>(size)), packet)
        << "whole";
    return true;
  }

  std::array<int, 2> ends_{};
};

TEST_F(ChannelFilterTest, PassesTheNamedChannelsOnly) {
  const std::vector<std::string> channels = {
      "TICK", "MODE", "TRACKS", "ARM_STATE_LEFT", "ARM_STATE_RIGHT", "A"};
  ASSERT_TRUE(AttachFilter(ends_[1], ChannelFilter(channels)));
  for (const std::string& channel : channels) {
    EXPECT_TRUE(Passes(Packet("LC02", channel))) << channel;
    EXPECT_FALSE(Passes(Packet("LC02", channel + "X"))) << channel;
    EXPECT_FALSE(Passes(Packet("LC02", "X" + channel))) << channel;
    std::string other = channel;
    other.back() = 'x';
    EXPECT_FALSE(Passes(Packet("LC02", other))) << other;
  }
  EXPECT_FALSE(Passes(Packet("LC02", "TICKS")));
  EXPECT_FALSE(Passes(Packet("LC02", "")));
}

TEST_F(ChannelFilterTest, AShortPacketIsNotLostToALongerName) {
  ASSERT_TRUE(AttachFilter(
      ends_[1], ChannelFilter({"A_CHANNEL_WITH_A_VERY_LONG_NAME", "B"})));
  EXPECT_TRUE(Passes(Packet("LC02", "B", 0)));
  EXPECT_FALSE(Passes(Packet("LC02", "C", 0)));
}

TEST_F(ChannelFilterTest, PassesFragmentsAndOtherData) {
  ASSERT_TRUE(AttachFilter(ends_[1], ChannelFilter({"TICK"})));
  EXPECT_TRUE(Passes(Packet("LC03", "anything")));
  EXPECT_TRUE(Passes(Packet("http", "")));
}

TEST_F(ChannelFilterTest, WithoutChannelsNothingPasses) {
  ASSERT_TRUE(AttachFilter(ends_[1], ChannelFilter({})));
  EXPECT_FALSE(Passes(Packet("LC02", "TICK")));
}

TEST_F(ChannelFilterTest, WhatTheKernelCannotTakeIsNotAttached) {
  const std::vector<std::string> channels(1000, "A_RATHER_LONG_NAME");
  EXPECT_THAT(ChannelFilter(channels), IsEmpty());
  EXPECT_FALSE(AttachFilter(ends_[1], ChannelFilter(channels)));
  EXPECT_FALSE(AttachFilter(-1, ChannelFilter({"A"})));
  EXPECT_TRUE(Passes(Packet("LC02", "B"))) << "as before";
}

TEST(SocketsOn, FindsThoseOfThePort) {
  const int mine = socket(AF_INET, SOCK_DGRAM, 0);
  const int other = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (const int descriptor : {mine, other}) {
    address.sin_port = 0;
    ASSERT_EQ(
        bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address),
        0);
  }
  socklen_t size = sizeof address;
  ASSERT_EQ(getsockname(mine, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const auto found = SocketsOn(ntohs(address.sin_port));
  EXPECT_THAT(found, ElementsAre(mine));
  EXPECT_THAT(found, Not(Contains(other)));
  close(mine);
  close(other);
}

}  // namespace
}  // namespace cell
