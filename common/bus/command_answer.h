#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "common/bus/bus.h"
#include "common/bus/decode.h"

namespace cell {

inline constexpr char kAnswerChannel[] = "ANSWER";

/// What a service answers to a command, in plain words: what follows from it,
/// or why it is refused and what would be right.
struct CommandAnswer {
  bool is_accepted = false;
  std::string text;

  static CommandAnswer Accept(std::string text) {
    return {true, std::move(text)};
  }
  static CommandAnswer Refuse(std::string text) {
    return {false, std::move(text)};
  }
};

/// Publishes the answer to the command with these bytes. @pre it has a header.
void PublishAnswer(Bus& bus, const std::string& channel,
                   std::span<const uint8_t> command,
                   const CommandAnswer& answer);

/// "7.20 s ago" and so on, if `deadline_utime` has passed.
CommandAnswer RefuseLate(int64_t deadline_utime, int64_t now);

/// Subscribes `handler` (const M&) -> CommandAnswer to a channel of commands.
/// Everything that comes there is answered, once: what cannot be decoded and
/// what is past its deadline is refused without the handler.
template <BusMessage M, class Handler>
void AnswerCommands(Bus& bus, const std::string& channel, Handler handler) {
  static_assert(
      std::is_same_v<std::invoke_result_t<Handler, const M&>, CommandAnswer>);
  const auto answer_to = [&bus, handler](const auto& bytes) {
    const auto message = Decode<M>(bytes);
    if (!message) {
      return CommandAnswer::Refuse(
          std::string("it is not a complete ") + M::getTypeName() +
          " of this build's message types (cell types)");
    }
    if constexpr (requires { message->deadline_utime; }) {
      if (bus.now() > message->deadline_utime) {
        return RefuseLate(message->deadline_utime, bus.now());
      }
    }
    return handler(*message);
  };
  bus.SubscribeBytes(channel, Bus::kAll,
                     [&bus, channel, answer_to](auto bytes) {
                       const CommandAnswer answer = answer_to(bytes);
                       PublishAnswer(bus, channel, bytes, answer);
                       return answer.is_accepted;
                     });
}

}  // namespace cell
