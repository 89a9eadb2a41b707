// LcmReceiver beside liblcm's own sender, in a private network.
#include "common/bus/lcm_receiver.h"

#include <gmock/gmock.h>

#include "common/bus/lcm_port.h"
#include "common/bus/private_network.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

class LcmReceiverTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { EnterPrivateNetwork(); }

  LcmReceiver Receiver(const LcmAddress& address, const Channels& channels) {
    return LcmReceiver(address.group, address.port, channels,
                       [this](const std::string& channel, Bytes bytes) {
                         heard_.emplace_back(channel, std::move(bytes));
                       });
  }

  std::vector<std::pair<std::string, Bytes>> heard_;
};

TEST_F(LcmReceiverTest, ReceivesShortAndLongMessagesInOrder) {
  const LcmAddress address{.port = 7751};
  LcmReceiver receiver = Receiver(address, kAllChannels);
  LcmPort sender(address.MainUrl());
  Bytes image(1'000'000);
  for (size_t i = 0; i < image.size(); ++i) {
    image[i] = static_cast<uint8_t>(i * i >> 3);
  }
  sender.Publish("A", {1});
  sender.Publish("FRAME", image);
  sender.Publish("B", {2});
  receiver.Drain();
  EXPECT_THAT(heard_, ElementsAre(Pair("A", Bytes{1}), Pair("FRAME", image),
                                  Pair("B", Bytes{2})));
}

TEST_F(LcmReceiverTest, ReceivesOnlyTheNamedChannelsOfItsGroup) {
  const LcmAddress address{.port = 7753};
  LcmReceiver receiver = Receiver(address, Channels({"TICK"}));
  LcmAddress other = address;
  other.group = "239.255.76.68";
  LcmReceiver others(other.group, other.port, kAllChannels,
                     [](const std::string&, const Bytes&) {});
  LcmPort other_port(other.MainUrl());
  LcmPort sender(address.MainUrl());
  other_port.Publish("TICK", {9});
  sender.Publish("TRACKS", {1});
  WaitForAny({&receiver}, 0);
  receiver.Drain();
  EXPECT_THAT(heard_, IsEmpty());
  sender.Publish("TICK", {2});
  receiver.Drain();
  EXPECT_THAT(heard_, ElementsAre(Pair("TICK", Bytes{2})));
}

TEST_F(LcmReceiverTest, AHandlersExceptionReachesTheCaller) {
  const LcmAddress address{.port = 7755};
  LcmReceiver receiver(address.group, address.port, kAllChannels,
                       [](const std::string& channel, const Bytes&) {
                         throw std::runtime_error(channel);
                       });
  LcmPort(address.MainUrl()).Publish("A", {1});
  EXPECT_THROW(receiver.Drain(), std::runtime_error);
}

}  // namespace
}  // namespace cell
