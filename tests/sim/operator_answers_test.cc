// Each command of an operator, and each request to the library, is answered
// once: accepted, or refused with a reason.
#include <gmock/gmock.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cell/answer_t.hpp"
#include "cell/command_episode_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/command_library_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/library_request_t.hpp"
#include "common/bus/manifest.h"
#include "tests/sim/assembling_cell.h"

namespace cell {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int32_t kLibraryTick = 20;  // then 21

/// Asks the library for an action that it does not have, then for one it has.
class Asker final : public Service {
 public:
  explicit Asker(Bus& bus) {
    bus.Every(1, 0, [&bus] {
      library_request_t request{};
      request.id = bus.tick() == kLibraryTick ? 99 : 1;
      if (bus.tick() == kLibraryTick || bus.tick() == kLibraryTick + 1) {
        bus.Publish("LIBRARY_REQUEST", request);
      }
    });
  }
};

/// A cell with an operator.
class OperatedCell {
 public:
  OperatedCell()
      : cell_(3, {{"asker", [](Bus& bus) -> std::unique_ptr<Service> {
                     return std::make_unique<Asker>(bus);
                   }}}) {
    cell_.On<answer_t>("ANSWER", [this](const answer_t& answer) {
      answers_[{answer.channel, answer.command_tick}].push_back(answer);
    });
    cell_.OnTick([this] {
      digests_.push_back(TickMessage(cell_.bus().last_tick()).digest);
    });
  }

  void Send(int32_t tick, const std::string& channel, Bytes bytes) {
    cell_.bus().Schedule(
        SimBus::TimedCommand{tick, {channel, std::move(bytes)}});
  }
  void Mode(int32_t tick, int8_t action, int32_t deadline = 1000) {
    command_mode_t command{};
    command.action = action;
    command.deadline_utime = deadline * kTickUs;
    Send(tick, "COMMAND_MODE", Bus::Encode(command));
  }
  void Goal(int32_t tick, const std::string& name) {
    command_goal_t command{};
    command.goal = name;
    command.deadline_utime = 1000 * kTickUs;
    Send(tick, "COMMAND_GOAL", Bus::Encode(command));
  }
  void Episode(int32_t tick, int8_t action, const std::string& name) {
    command_episode_t command{};
    command.action = action;
    command.demonstration = name;
    command.deadline_utime = 1000 * kTickUs;
    Send(tick, "COMMAND_EPISODE", Bus::Encode(command));
  }
  void Edit(int32_t tick, int8_t kind, const std::string& name,
            const std::string& other = "") {
    command_library_t command{};
    command.kind = kind;
    command.name = name;
    command.other = other;
    command.deadline_utime = 1000 * kTickUs;
    Send(tick, "COMMAND_LIBRARY", Bus::Encode(command));
  }
  void Run() { cell_.Run(500); }

  /// The only answer to the command of that tick.
  answer_t AnswerTo(const std::string& channel, int32_t tick) const {
    const auto found = answers_.find({channel, tick});
    if (found == answers_.end() || found->second.size() != 1) {
      ADD_FAILURE() << channel << " of tick " << tick << " has not one answer";
      return {};
    }
    return found->second.front();
  }
  void ExpectAccepted(const std::string& channel, int32_t tick,
                      const std::string& text) const {
    const answer_t answer = AnswerTo(channel, tick);
    EXPECT_EQ(answer.outcome, answer_t::ACCEPTED) << channel << " " << tick;
    EXPECT_THAT(answer.text, HasSubstr(text));
  }
  void ExpectRefused(const std::string& channel, int32_t tick,
                     const std::string& text) const {
    const answer_t answer = AnswerTo(channel, tick);
    EXPECT_EQ(answer.outcome, answer_t::REFUSED) << channel << " " << tick;
    EXPECT_THAT(answer.text, HasSubstr(text));
  }
  const std::vector<int64_t>& digests() const { return digests_; }

 private:
  AssemblingCell cell_;
  std::map<std::pair<std::string, int32_t>, std::vector<answer_t>> answers_;
  std::vector<int64_t> digests_;
};

TEST(OperatorAnswers, ModesAreTakenUnlessTheyAreLateOrUnknown) {
  OperatedCell cell;
  cell.Mode(50, command_mode_t::HOLD);
  cell.Mode(60, 7);
  cell.Mode(70, command_mode_t::RESUME);
  cell.Mode(80, command_mode_t::HOLD, 10);
  cell.Run();
  cell.ExpectAccepted("COMMAND_MODE", 50, "resume");
  cell.ExpectRefused("COMMAND_MODE", 60, "7");
  cell.ExpectAccepted("COMMAND_MODE", 70, "nothing holds");
  cell.ExpectRefused("COMMAND_MODE", 80, "past its deadline");
}

TEST(OperatorAnswers, TheLibraryIsChangedWhileTheCellRuns) {
  OperatedCell cell;
  cell.Edit(30, command_library_t::RENAME, "PlaceRoundPeg", "Plug");
  cell.Edit(40, command_library_t::REMOVE, "Plug");
  cell.Edit(50, command_library_t::MERGE, "Plug", "ScrewHead");
  cell.Edit(60, command_library_t::TAKE_BACK, "assembly 2");
  cell.Edit(70, command_library_t::ROLL_BACK, "");
  cell.Edit(80, command_library_t::ROLL_BACK, "");
  cell.Edit(90, 9, "");
  cell.Run();
  cell.ExpectAccepted("COMMAND_LIBRARY", 30,
                      "Plug, RemoveRoundPeg, PlaceRoundPeg (removed)");
  cell.ExpectRefused("COMMAND_LIBRARY", 40, "'RemoveRoundPeg' undoes it");
  cell.ExpectRefused("COMMAND_LIBRARY", 50, "does not change what ScrewHead");
  cell.ExpectAccepted("COMMAND_LIBRARY", 60, "Plug");
  cell.ExpectAccepted("COMMAND_LIBRARY", 70, "PlaceRoundPeg");
  cell.ExpectRefused("COMMAND_LIBRARY", 80, "already holds that");
  cell.ExpectRefused("COMMAND_LIBRARY", 90, "no kind 9");
}

TEST(OperatorAnswers, AGoalIsTakenByTheEpisodeThatRuns) {
  OperatedCell cell;
  cell.Goal(30, "nonsense");
  cell.Goal(40, "round_pegs");
  cell.Send(50, "COMMAND_GOAL", Bus::Encode(command_mode_t{}));
  cell.Episode(100, command_episode_t::START, "two_pegs");
  cell.Goal(110, "assembled");  // between the episodes
  cell.Goal(300, "round_pegs");
  cell.Run();
  cell.ExpectRefused("COMMAND_GOAL", 30,
                     "no goal 'nonsense'; known: assembled");
  cell.ExpectAccepted("COMMAND_GOAL", 40, "round_pegs");
  cell.ExpectRefused("COMMAND_GOAL", 50, "command_goal_t");
  cell.ExpectRefused("COMMAND_GOAL", 110, "no episode is running");
  cell.ExpectAccepted("COMMAND_GOAL", 300, "round_pegs");
}

TEST(OperatorAnswers, AnEpisodeThatCannotBeginLeavesTheOneThatRuns) {
  OperatedCell cell;
  cell.Episode(20, command_episode_t::START, "nonsense");
  cell.Episode(30, 7, "two_pegs");
  cell.Episode(100, command_episode_t::START, "two_pegs");
  cell.Episode(300, command_episode_t::END, "");
  cell.Run();
  const answer_t refusal = cell.AnswerTo("COMMAND_EPISODE", 20);
  EXPECT_EQ(refusal.outcome, answer_t::REFUSED);
  EXPECT_THAT(refusal.text,
              AllOf(HasSubstr("'nonsense'"), HasSubstr("two_pegs")));
  cell.ExpectRefused("COMMAND_EPISODE", 30, "7");
  cell.ExpectAccepted("COMMAND_EPISODE", 100,
                      "episode 1 (execution) has ended");
  cell.ExpectAccepted("COMMAND_EPISODE", 300, "episode 2 (two_pegs) has ended");
}

TEST(OperatorAnswers, TheLibraryReportsAnActionThatItDoesNotHave) {
  OperatedCell cell;
  cell.Run();
  cell.ExpectRefused("LIBRARY_REQUEST", kLibraryTick, "99");
  cell.ExpectAccepted("LIBRARY_REQUEST", kLibraryTick + 1, "ACTION_RECORD");
}

TEST(OperatorAnswers, AreTheSameBytesInEveryRun) {
  const auto run = [] {
    OperatedCell cell;
    cell.Goal(30, "nonsense");
    cell.Mode(50, command_mode_t::HOLD);
    cell.Episode(100, command_episode_t::END, "");
    cell.Run();
    return cell.digests();
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace cell
