#include "common/bus/command_answer.h"

#include <fmt/format.h>

#include "cell/answer_t.hpp"

namespace cell {

void PublishAnswer(Bus& bus, const std::string& channel,
                   std::span<const uint8_t> command,
                   const CommandAnswer& answer) {
  const WireHeader header =
      ReadWireHeader(Bytes(command.begin(), command.begin() + kWireHeaderEnd));
  answer_t message{};
  message.header.utime = header.utime;
  message.channel = channel;
  message.command_tick = header.tick;
  message.command_sender = header.sender;
  message.command_seq = header.seq;
  message.outcome = answer.is_accepted ? answer_t::ACCEPTED : answer_t::REFUSED;
  message.text = answer.text;
  bus.Publish(kAnswerChannel, message);
}

CommandAnswer RefuseLate(int64_t deadline_utime, int64_t now) {
  return CommandAnswer::Refuse(fmt::format(
      "it arrived at {:.2f} s, {:.2f} s past its deadline; give it a later "
      "--deadline",
      1e-6 * static_cast<double>(now),
      1e-6 * (static_cast<double>(now) - static_cast<double>(deadline_utime))));
}

}  // namespace cell
