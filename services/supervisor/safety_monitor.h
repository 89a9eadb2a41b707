#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/supervisor/stop_policy.h"

namespace cell::supervisor {

enum class Mode {
  kIdle,     ///< no episode
  kMonitor,  ///< a person's
  kExecute,  ///< the robot's
  kHold
};

/// The mode of the cell and why.
struct Operation {
  Mode mode = Mode::kIdle;
  Hold hold = Hold::kNone;
  std::string reason;         ///< of a hold, in plain words
  bool is_operators = false;  ///< a hold that the operator has asked for
  bool operator==(const Operation&) const = default;
};

/// Something a person must know.
struct Event {
  enum class Cause { kSilent, kHeld, kRestarted };
  AlertLevel level;
  Cause cause;
  std::string text;
};

/// Decides whether arms may move. A hold ends by itself when the silent service
/// publishes again; an operator's hold and one after a protective stop end when
/// the operator resumes. Times in us.
class SafetyMonitor {
 public:
  enum class Agent { kPerson, kRobot };

  /// Counts all services as heard at `now`, so that none is dead at once.
  SafetyMonitor(StopPolicy table, int64_t now);

  /// Of a service that is not in the table: nothing.
  void OnMessage(const std::string& service, int64_t now);
  /// The service, in the table or not, has reported its incarnation: a new one
  /// has lost its state.
  void OnIncarnation(const std::string& service, int32_t incarnation);
  /// Nothing: no episode.
  void SetAgent(std::optional<Agent> agent) { agent_ = agent; }
  void HoldByOperator();
  void ResumeByOperator();
  /// `why`: which limit, and what was measured.
  void StopProtectively(const std::string& arm, const std::string& why);
  /// Looks for silence. Every event since the last call.
  std::vector<Event> Update(int64_t now);

  Operation operation() const;

 private:
  struct Cause {
    Hold hold;
    std::string reason;
  };
  struct Row {
    HoldRow row;
    int64_t heard;
    bool is_silent = false;
  };

  void Note(AlertLevel level, Event::Cause cause, std::string text);

  Hold operator_hold_;
  std::vector<Row> rows_;
  std::map<std::string, int32_t> incarnations_;  // by service
  std::map<std::string, Cause> silent_;          // by service
  std::map<std::string, Cause> operators_;       // until the operator resumes
  std::optional<Agent> agent_;
  std::vector<Event> events_;
};

}  // namespace cell::supervisor
