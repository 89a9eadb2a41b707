#include "common/bus/packet_assembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cell {
namespace {

constexpr uint64_t kSender = 7;

void AppendWord(uint32_t value, int num_bytes, Bytes& packet) {
  for (int i = num_bytes; i-- > 0;) {
    packet.push_back(static_cast<uint8_t>(value >> (8 * i)));
  }
}

void AppendName(const std::string& channel, Bytes& packet) {
  packet.insert(packet.end(), channel.begin(), channel.end());
  packet.push_back(0);
}

Bytes Short(const std::string& channel, const Bytes& data) {
  Bytes packet;
  AppendWord(0x4c433032, 4, packet);
  AppendWord(0, 4, packet);
  AppendName(channel, packet);
  packet.insert(packet.end(), data.begin(), data.end());
  return packet;
}

// The packets of a message, at most `size` bytes of it in each.
std::vector<Bytes> Fragments(uint32_t sequence, const std::string& channel,
                             const Bytes& data, size_t size) {
  const size_t count = (data.size() + size - 1) / size;
  std::vector<Bytes> packets;
  for (size_t i = 0; i < count; ++i) {
    const size_t begin = i * size, end = std::min(begin + size, data.size());
    Bytes& packet = packets.emplace_back();
    AppendWord(0x4c433033, 4, packet);
    AppendWord(sequence, 4, packet);
    AppendWord(static_cast<uint32_t>(data.size()), 4, packet);
    AppendWord(static_cast<uint32_t>(begin), 4, packet);
    AppendWord(static_cast<uint32_t>(i), 2, packet);
    AppendWord(static_cast<uint32_t>(count), 2, packet);
    if (i == 0) AppendName(channel, packet);
    packet.insert(packet.end(), data.begin() + static_cast<int64_t>(begin),
                  data.begin() + static_cast<int64_t>(end));
  }
  return packets;
}

Bytes SomeBytes(size_t size, std::mt19937_64& random) {
  Bytes bytes(size);
  for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
  return bytes;
}

PacketAssembler All() {
  return PacketAssembler([](const std::string&) { return true; });
}

TEST(PacketAssembler, PassesOnAShortMessageUnchanged) {
  const auto arrival = All().Put(kSender, Short("TICK", {1, 0, 3}));
  ASSERT_TRUE(arrival);
  EXPECT_EQ(arrival->channel, "TICK");
  EXPECT_EQ(arrival->bytes, (Bytes{1, 0, 3}));
  EXPECT_TRUE(All().Put(kSender, Short("TICK", {}))->bytes.empty());
}

TEST(PacketAssembler, JoinsTheFragmentsOfEachSender) {
  std::mt19937_64 random(1);
  PacketAssembler assembler = All();
  for (const size_t size : {9u, 10u, 11u, 1000u}) {
    const Bytes mine = SomeBytes(size, random);
    const Bytes others = SomeBytes(size, random);
    const auto packets = Fragments(3, "FRAME_1", mine, 10);
    const auto between = Fragments(3, "FRAME_2", others, 10);
    for (size_t i = 0; i < packets.size(); ++i) {
      const auto arrival = assembler.Put(1, packets[i]);
      const auto other = assembler.Put(2, between[i]);
      ASSERT_EQ(arrival.has_value(), i + 1 == packets.size()) << size;
      ASSERT_EQ(other.has_value(), i + 1 == packets.size()) << size;
      if (!arrival) continue;
      EXPECT_EQ(arrival->channel, "FRAME_1");
      EXPECT_EQ(arrival->bytes, mine);
      EXPECT_EQ(other->bytes, others);
    }
  }
}

TEST(PacketAssembler, LeavesUnwantedChannelsAlone) {
  PacketAssembler assembler(
      [](const std::string& channel) { return channel == "TICK"; });
  EXPECT_FALSE(assembler.Put(kSender, Short("TICKS", {1})));
  for (const Bytes& packet : Fragments(1, "FRAME_1", Bytes(30, 5), 10)) {
    EXPECT_FALSE(assembler.Put(kSender, packet));
  }
  EXPECT_TRUE(assembler.Put(kSender, Short("TICK", {1})));
}

TEST(PacketAssembler, AMessageWithALostFragmentIsNotJoined) {
  const Bytes data(30, 5);
  for (const size_t lost : {0u, 1u, 2u}) {
    PacketAssembler assembler = All();
    auto packets = Fragments(1, "FRAME_1", data, 10);
    packets.erase(packets.begin() + static_cast<int64_t>(lost));
    for (const Bytes& packet : packets) {
      EXPECT_FALSE(assembler.Put(kSender, packet));
    }
    packets = Fragments(2, "FRAME_1", data, 10);
    EXPECT_FALSE(assembler.Put(kSender, packets[0]));
    EXPECT_FALSE(assembler.Put(kSender, packets[1]));
    EXPECT_EQ(assembler.Put(kSender, packets[2])->bytes, data) << "the next";
  }
}

TEST(PacketAssembler, ANameWithoutItsEndIsNoMessage) {
  Bytes packet = Short(std::string(10, 'A'), {});
  packet.pop_back();
  EXPECT_FALSE(All().Put(kSender, packet));
  EXPECT_TRUE(All().Put(kSender, Short(std::string(63, 'A'), {})));
  EXPECT_FALSE(All().Put(kSender, Short(std::string(64, 'A'), {})));
}

// Whatever is changed in a packet, the message is the sender's or none; with
// other numbers of fragments the sizes would not fit.
TEST(PacketAssembler, AForgedHeaderCompletesNothing) {
  std::mt19937_64 random(2);
  const Bytes data = SomeBytes(100, random);
  for (int i = 0; i < 20'000; ++i) {
    PacketAssembler assembler = All();
    auto packets = Fragments(1, "F", data, 30);
    Bytes& forged = packets[random() % packets.size()];
    const size_t at = 8 + random() % 12;  // sizes, offsets, numbers
    forged[at] ^= static_cast<uint8_t>(1 + random() % 255);
    if (random() % 4 == 0) forged.resize(random() % (forged.size() + 1));
    for (const Bytes& packet : packets) {
      EXPECT_FALSE(assembler.Put(kSender, packet)) << "byte " << at;
    }
  }
}

TEST(PacketAssembler, RandomBytesAreNoMessage) {
  std::mt19937_64 random(3);
  PacketAssembler assembler = All();
  for (int i = 0; i < 100'000; ++i) {
    Bytes packet = SomeBytes(random() % 60, random);
    if (packet.size() >= 4) {
      packet[0] = 'L', packet[1] = 'C', packet[2] = '0', packet[3] = '3';
    }
    EXPECT_FALSE(assembler.Put(random() % 3, packet));
  }
}

TEST(PacketAssembler, HoldsNoMoreThanItsShare) {
  PacketAssembler assembler = All();
  const auto packets = Fragments(1, "F", Bytes(60u << 20, 1), 30u << 20);
  EXPECT_FALSE(assembler.Put(1, packets[0]));
  EXPECT_FALSE(assembler.Put(2, packets[0])) << "no room for both";
  EXPECT_FALSE(assembler.Put(2, packets[1]));
  EXPECT_TRUE(assembler.Put(1, packets[1]));
  EXPECT_FALSE(assembler.Put(2, packets[0]));
  EXPECT_TRUE(assembler.Put(2, packets[1])) << "and now there is";
}

}  // namespace
}  // namespace cell
