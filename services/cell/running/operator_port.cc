#include "services/cell/running/operator_port.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "common/bus/command_answer.h"
#include "common/bus/decode.h"
#include "common/node/number_option.h"

namespace cell::cli {
namespace {

constexpr int kStepMs = 20;
/// Before the command: if nothing is heard for this long, there is no cell.
constexpr int kMaxFirstSilenceMs = 5'000;
/// After it, without a message that carries the cell's time.
constexpr int kMaxSilenceMs = 10'000;
/// [us of the cell's time] An answer may come so long after the deadline: a
/// service that plans looks at its messages afterwards.
constexpr int64_t kAnswerTime = 5'000'000;

}  // namespace

void AddOperatorOptions(CLI::App& command, OperatorOptions* options) {
  options->address.AddTo(command);
  command
      .add_option(
          "--deadline", options->deadline_s,
          "refuse the command after this many seconds of the cell's time")
      ->check(NumberIn(0., 3600.))
      ->capture_default_str();
}

// The cell's present time comes from a message of every tick: TICK in lockstep,
// MOTION_PERMIT in a live cell.
OperatorPort::OperatorPort(const OperatorOptions& options,
                           OperatorCommand command)
    : OperatorPort(options.address.Reach(), options.deadline_s,
                   std::move(command)) {}

OperatorPort::OperatorPort(const LcmAddress& address, double deadline_s,
                           OperatorCommand command)
    : command_(std::move(command)),
      deadline_s_(deadline_s),
      control_(address.ControlUrl()),
      main_(address.MainUrl()) {
  main_.SubscribeTo(std::vector<std::string>{kTickChannel, "MOTION_PERMIT",
                                             kAnswerChannel, command_.channel},
                    [this](const std::string& channel, const Bytes& bytes) {
                      OnMessage(channel, bytes);
                    });
  while (!utime_ && silent_ms_ < kMaxFirstSilenceMs) {
    silent_ms_ += kStepMs;
    WaitForAny({&main_}, kStepMs);
    main_.Drain();
  }
  if (!utime_) {
    throw std::runtime_error(
        fmt::format("neither TICK nor MOTION_PERMIT heard in {} s: is the cell "
                    "running (cell status), and on this --url?",
                    kMaxFirstSilenceMs / 1000));
  }
}

int64_t OperatorPort::DeadlineUtime() const {
  return *utime_ + std::llround(deadline_s_ * 1e6);
}

void OperatorPort::OnMessage(const std::string& channel, const Bytes& bytes) {
  if (bytes.size() < kWireHeaderEnd) return;
  if (channel == kAnswerChannel) {
    const auto answer = Decode<answer_t>(bytes);
    if (answer && answer->channel == command_.channel) {
      answers_.push_back(*answer);
    }
  } else if (channel == command_.channel) {
    Bytes as_sent = bytes;
    WriteIdentity(0, 0, 0, as_sent);
    if (!passed_on_ && as_sent == sent_) passed_on_ = ReadWireHeader(bytes);
  } else {
    utime_ = ReadWireHeader(bytes).utime;
    silent_ms_ = 0;
  }
}

// The clock gives a command its place among the messages, by which its answer
// names it.
const answer_t* OperatorPort::FindAnswer() const {
  if (!passed_on_) return nullptr;
  for (const answer_t& answer : answers_) {
    if (answer.command_tick == passed_on_->tick &&
        answer.command_sender == passed_on_->sender &&
        answer.command_seq == passed_on_->seq) {
      return &answer;
    }
  }
  return nullptr;
}

bool OperatorPort::IsTooLate() const {
  return *utime_ > deadline_utime_ + kAnswerTime || silent_ms_ >= kMaxSilenceMs;
}

int OperatorPort::Execute(const Bytes& bytes) {
  sent_ = bytes;
  deadline_utime_ = DeadlineUtime();
  control_.Publish(command_.channel, sent_);
  const answer_t* answer = nullptr;
  for (silent_ms_ = 0; !(answer = FindAnswer()); silent_ms_ += kStepMs) {
    if (IsTooLate()) Fail();
    WaitForAny({&main_}, kStepMs);
    main_.Drain();
  }
  const bool is_accepted = answer->outcome == answer_t::ACCEPTED;
  (is_accepted ? std::cout : std::cerr)
      << fmt::format("{} {}: {}\n", command_.what,
                     is_accepted ? "accepted" : "refused", answer->text);
  return is_accepted ? 0 : 1;
}

void OperatorPort::Fail() const {
  const std::string since =
      silent_ms_ >= kMaxSilenceMs
          ? fmt::format("the cell has been silent for {} s", silent_ms_ / 1000)
          : fmt::format("its deadline, {:.2f} s, has passed",
                        1e-6 * static_cast<double>(deadline_utime_));
  throw std::runtime_error(
      passed_on_
          ? fmt::format(
                "{}: no answer from {}, and {}; is it running (cell status)?",
                command_.what, command_.service, since)
          : fmt::format("{}: the clock has not forwarded {}, and {}",
                        command_.what, command_.channel, since));
}

}  // namespace cell::cli
