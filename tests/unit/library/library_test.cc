// The library on a bus: what it answers, and that it keeps its answers in spite
// of a death.
#include "services/library/library.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "cell/answer_t.hpp"
#include "cell/command_library_t.hpp"
#include "cell/store_answer_t.hpp"
#include "common/actions/action_model_writer.h"
#include "common/bus/manifest.h"
#include "common/bus/replay.h"
#include "common/bus/run_log.h"
#include "common/bus/sim_bus.h"
#include "common/bus/stepper.h"
#include "services/library/content_file.h"
#include "services/library/memory_action_store.h"
#include "tests/test_folder.h"
#include "tests/unit/keeping_cell.h"
#include "tests/unit/library/some_experiences.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace library;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int32_t kNumTicks = 130;
constexpr size_t kNumOfTask = 15;

template <class M>
M DecodedAs(const Message& message) {
  M decoded{};
  const int size = static_cast<int>(message.bytes->size());
  EXPECT_EQ(decoded.decode(message.bytes->data(), 0, size), size);
  return decoded;
}

/// What the library said in a run.
struct Said {
  std::vector<store_answer_t> stored;
  std::vector<action_record_t> records;
  std::vector<store_answer_t> kept;  // of experiences
  std::vector<experience_t> experiences;
  std::vector<int64_t> digests;  // of the ticks
};

Said RunCell(const Deployment& deployment,
             std::vector<SimBus::Outage> outages = {}) {
  SimBus bus(keeping::TheRoster(), keeping::Factories(deployment, kNumTicks),
             std::move(outages));
  Said said;
  while (bus.Step()) {
    said.digests.push_back(TickMessage(bus.last_tick()).digest);
    for (const Message& message : bus.last_messages()) {
      if (message.channel == "STORED") {
        const auto answer = DecodedAs<store_answer_t>(message);
        const bool is_of_action = answer.channel == "STORE_REQUEST";
        (is_of_action ? said.stored : said.kept).push_back(answer);
      } else if (message.channel == "EXPERIENCE") {
        said.experiences.push_back(DecodedAs<experience_t>(message));
      } else if (message.channel == "ACTION_RECORD") {
        said.records.push_back(DecodedAs<action_record_t>(message));
      }
    }
  }
  return said;
}

std::vector<std::string> NamesPublishedIn(const Said& said, int32_t tick) {
  std::vector<std::string> names;
  for (const action_record_t& record : said.records) {
    if (record.header.tick == tick) names.push_back(record.name);
  }
  return names;
}

TEST(LibraryService, PublishesAllThatItKnowsAsAnEpisodeStarts) {
  const Said said = RunCell(ShippedDeployment());
  const auto names = NamesPublishedIn(said, 3);
  ASSERT_EQ(names.size(), kNumOfTask);
  const ShippedTask task;
  for (size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(names[i], task.domain.actions()[i].name);
    EXPECT_EQ(said.records[i].id, static_cast<int64_t>(i) + 1);
  }
}

TEST(LibraryService, AnswersEveryRequestWithAnIdOrAReason) {
  const Said said = RunCell(ShippedDeployment());
  int64_t next_id = kNumOfTask + 1;
  int num_refused = 0;
  for (const store_answer_t& answer : said.stored) {
    const int32_t asked = answer.header.tick - 1;
    EXPECT_EQ(answer.request_sender, 1);
    EXPECT_EQ(answer.request_seq, asked - 5);
    EXPECT_EQ(answer.header.utime, asked * kTickUs);
    const auto published = NamesPublishedIn(said, answer.header.tick);
    const std::string name = keeping::RequestOf(asked).name;
    if (asked % 10 == 3 && asked > 10) {
      EXPECT_EQ(answer.outcome, store_answer_t::DUPLICATE);
      EXPECT_EQ(answer.id, next_id - 1);
      EXPECT_THAT(answer.reason, HasSubstr("already exists, with id"));
      ++num_refused;
    } else if (asked % 10 == 7) {
      EXPECT_EQ(answer.outcome, store_answer_t::INVALID);
      EXPECT_EQ(answer.id, 0);
      EXPECT_THAT(answer.reason, HasSubstr(name + ":rules[0]"));
      ++num_refused;
    } else {
      EXPECT_EQ(answer.outcome, store_answer_t::STORED) << answer.reason;
      EXPECT_EQ(answer.id, next_id++);
      EXPECT_THAT(published, testing::Contains(name));
      EXPECT_EQ(answer.reason, "");
    }
  }
  EXPECT_GT(num_refused, 20);
  EXPECT_GT(said.stored.size(), 100u);
}

std::vector<int64_t> ExperiencesPublishedIn(const Said& said, int32_t tick) {
  std::vector<int64_t> ids;
  for (const experience_t& experience : said.experiences) {
    if (experience.header.tick == tick) ids.push_back(experience.id);
  }
  return ids;
}

TEST(LibraryService, KeepsExperiencesAndTellsThemWithTheirId) {
  const Said said = RunCell(ShippedDeployment());
  int64_t next_id = 1;
  int num_refused = 0;
  for (const store_answer_t& answer : said.kept) {
    const int32_t asked = answer.header.tick - 1;
    EXPECT_EQ(answer.channel, "EXPERIENCE_REQUEST");
    EXPECT_EQ(answer.request_seq, asked - 5);
    const auto published = ExperiencesPublishedIn(said, answer.header.tick);
    if (asked % 10 == 4) {
      EXPECT_EQ(answer.outcome, store_answer_t::INVALID);
      EXPECT_EQ(answer.id, 0);
      EXPECT_THAT(answer.reason,
                  HasSubstr("after[0]: the task has no object 'nobody'"));
      ++num_refused;
    } else {
      EXPECT_EQ(answer.outcome, store_answer_t::STORED) << answer.reason;
      EXPECT_EQ(answer.id, next_id++);
      EXPECT_EQ(published.front(), answer.id);
    }
  }
  EXPECT_GT(num_refused, 10);
  EXPECT_GT(next_id, 100);
  EXPECT_EQ(said.experiences.front().header.utime, 5 * kTickUs);
}

TEST(LibraryService, DoesTheSameInEveryRun) {
  EXPECT_EQ(RunCell(ShippedDeployment()).digests,
            RunCell(ShippedDeployment()).digests);
}

TEST(LibraryService, HasAfterADeathExactlyWhatItStoredBefore) {
  const Said said = RunCell(ShippedDeployment(), {{"library", 50, 61}});
  // Asked for in tick 80, published one later.
  const auto names = NamesPublishedIn(said, 2 * keeping::kRequestPeriod + 1);
  std::vector<std::string> expected;
  for (const ActionRecord& record :
       WriteActionModels(ShippedTask().actions, ShippedTask().domain)) {
    expected.push_back(record.name);
  }
  for (const store_answer_t& answer : said.stored) {
    const int32_t k = answer.header.tick;
    if (k > 2 * keeping::kRequestPeriod + 1) break;
    EXPECT_TRUE(k < 50 || k > 61) << k;
    if (answer.outcome != store_answer_t::STORED) continue;
    expected.push_back(keeping::RequestOf(k - 1).name);
  }
  // LIBRARY_REQUEST is handled before the tick's STORE_REQUEST.
  const std::string last = expected.back();
  expected.pop_back();
  ASSERT_EQ(names.size(), expected.size() + 1);
  EXPECT_EQ(names.back(), last);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), names.begin()));
}

TEST(LibraryService, HasAfterADeathExactlyTheExperiencesItAnswered) {
  const Said said = RunCell(ShippedDeployment(), {{"library", 50, 61}});
  std::set<int64_t> answered;
  for (const store_answer_t& answer : said.kept) {
    if (answer.header.tick > 2 * keeping::kRequestPeriod) break;
    if (answer.outcome == store_answer_t::STORED) answered.insert(answer.id);
  }
  // Asked for in tick 80, told one later: first the one that was just kept.
  auto told = ExperiencesPublishedIn(said, 2 * keeping::kRequestPeriod + 1);
  const int64_t fresh = told.front();
  told.erase(told.begin());
  answered.insert(fresh);
  ASSERT_LE(static_cast<int64_t>(answered.size()), Library::kToldPerTick);
  EXPECT_EQ(told, std::vector<int64_t>(answered.begin(), answered.end()));
}

/// An incarnation of the library, told in its first tick when the last one
/// died.
class Incarnation {
 public:
  Incarnation(std::shared_ptr<ActionStore> store, int32_t join_tick,
              int32_t death_tick)
      : service_(MakeLibrary(stepper_, ShippedDeployment(), store)),
        tick_(join_tick) {
    tick_t tick{};
    tick.header.tick = join_tick;
    tick.joined.resize(1);
    tick.num_joined = 1;
    tick.joined[0].name = "library";
    tick.joined[0].death_tick = death_tick;
    Step({TickMessage(tick)});
  }
  std::vector<Message> Ask(const std::string& name) {
    return Store(keeping::Good(name));
  }
  std::vector<Message> Episode(int8_t phase) {
    episode_t episode{};
    episode.phase = phase;
    Bytes bytes = Bus::Encode(episode);
    WriteIdentity(tick_ - 1, 0, tick_ - 1, bytes);
    return Step({*MessageFromWire("EPISODE", std::move(bytes))});
  }
  std::vector<Message> Store(const ActionRecord& record) {
    Bytes bytes = Bus::Encode(ToMessage(record));
    WriteIdentity(tick_ - 1, 1, tick_ - 1, bytes);
    return Step({*MessageFromWire("STORE_REQUEST", std::move(bytes))});
  }
  std::vector<Message> Keep(const ExperienceRecord& experience) {
    Bytes bytes = Bus::Encode(ToMessage(experience));
    WriteIdentity(tick_ - 1, 1, tick_ - 1, bytes);
    return Step({*MessageFromWire("EXPERIENCE_REQUEST", std::move(bytes))});
  }
  std::vector<Message> Edit(int8_t kind, const std::string& name,
                            const std::string& other) {
    command_library_t command{};
    command.kind = kind;
    command.name = name;
    command.other = other;
    command.deadline_utime = std::numeric_limits<int64_t>::max();
    Bytes bytes = Bus::Encode(command);
    WriteIdentity(tick_ - 1, 1, tick_ - 1, bytes);
    return Step({*MessageFromWire("COMMAND_LIBRARY", std::move(bytes))});
  }
  std::vector<Message> Wait() { return Step({}); }
  std::vector<Message> Request(int64_t id) {
    library_request_t request{};
    request.id = id;
    Bytes bytes = Bus::Encode(request);
    WriteIdentity(tick_ - 1, 1, tick_ - 1, bytes);
    return Step({*MessageFromWire("LIBRARY_REQUEST", std::move(bytes))});
  }

 private:
  std::vector<Message> Step(std::vector<Message> inputs) {
    EXPECT_EQ(stepper_.Accept(tick_++, std::move(inputs)),
              Stepper::State::kReady);
    return stepper_.Run();
  }

  Stepper stepper_{{.name = "library"}};
  std::unique_ptr<Service> service_;
  int32_t tick_;
};

TEST(LibraryService, ForgetsWhatItStoredInTheTickThatItDidNotAnswer) {
  const auto store = std::make_shared<MemoryActionStore>();
  {
    Incarnation library(store, 0, -1);
    library.Ask("InTick1");
    library.Ask("InTick2");  // killed before its ACK
  }
  { Incarnation library(store, 9, 2); }
  EXPECT_EQ(store->All().size(), 1u);
  EXPECT_TRUE(store->FindNamed("InTick1"));
}

TEST(LibraryService, KeepsAllOfEarlierRunsWhateverTicksTheyHad) {
  const auto store = std::make_shared<MemoryActionStore>();
  {
    Incarnation library(store, 800, -1);
    library.Ask("Early");
  }
  { Incarnation library(store, 0, -1); }  // of the next run
  { Incarnation library(store, 40, 20); }
  EXPECT_TRUE(store->FindNamed("Early"));
  // Killed in its first tick, before or after it had done anything in it.
  { Incarnation library(store, 1, 0); }
  EXPECT_TRUE(store->FindNamed("Early"));
}

TEST(LibraryService, PublishesTheOneThatIsAskedFor) {
  const auto store = std::make_shared<MemoryActionStore>();
  Incarnation library(store, 0, -1);
  library.Ask("One");
  const auto two = library.Ask("Two");
  ASSERT_EQ(two.size(), 2u);
  const auto found = library.Request(2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(DecodedAs<action_record_t>(found[0]).name, "Two");
  EXPECT_EQ(DecodedAs<answer_t>(found[1]).outcome, answer_t::ACCEPTED);
  const auto missing = library.Request(3);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(DecodedAs<answer_t>(missing[0]).outcome, answer_t::REFUSED);
  EXPECT_EQ(library.Request(0).size(), 3u);
}

TEST(LibraryService, ReplacesAnActionByItsNextVersion) {
  const auto store = std::make_shared<MemoryActionStore>();
  Incarnation library(store, 0, -1);
  library.Ask("One");
  library.Ask("Two");
  ActionRecord next = keeping::Good("One");
  next.version = 2;
  const auto said = library.Store(next);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(DecodedAs<store_answer_t>(said[0]).outcome, store_answer_t::STORED);
  const auto record = DecodedAs<action_record_t>(said[1]);
  EXPECT_EQ(record.version, 2);
  EXPECT_EQ(record.id, 3);
  EXPECT_EQ(library.Request(0).size(), 3u);  // and the answer
}

TEST(LibraryService, PublishesAllOnceToAnEpisodeThatItJoins) {
  const auto store = std::make_shared<MemoryActionStore>();
  Incarnation library(store, 30, 20);
  library.Ask("One");
  EXPECT_EQ(library.Episode(episode_t::RUNNING).size(), 1u);
  EXPECT_EQ(library.Episode(episode_t::RUNNING).size(), 0u);
  EXPECT_EQ(library.Episode(episode_t::START).size(), 1u);
}

std::vector<experience_t> ExperiencesAmong(
    const std::vector<Message>& messages) {
  std::vector<experience_t> experiences;
  for (const Message& message : messages) {
    if (message.channel == "EXPERIENCE") {
      experiences.push_back(DecodedAs<experience_t>(message));
    }
  }
  return experiences;
}

TEST(LibraryService, TellsAllExperiencesInPortionsAsAnEpisodeStarts) {
  const auto store = std::make_shared<MemoryActionStore>();
  constexpr int64_t kNum = 2 * Library::kToldPerTick + 5;
  for (int64_t i = 0; i < kNum; ++i) store->Keep(Tried("New"), kBeforeRun);
  Incarnation library(store, 0, -1);
  std::vector<int64_t> ids;
  auto said = library.Episode(episode_t::START);
  for (int tick = 0; tick < 5; ++tick) {
    const auto experiences = ExperiencesAmong(said);
    EXPECT_LE(static_cast<int64_t>(experiences.size()), Library::kToldPerTick);
    for (const experience_t& e : experiences) ids.push_back(e.id);
    said = library.Wait();
  }
  ASSERT_EQ(static_cast<int64_t>(ids.size()), kNum);
  EXPECT_TRUE(std::ranges::is_sorted(ids));
  EXPECT_EQ(ids.back(), kNum);
}

TEST(LibraryService, TagsExperiencesWithTheDemonstration) {
  const auto store = std::make_shared<MemoryActionStore>();
  Incarnation library(store, 0, -1);
  library.Episode(episode_t::START);
  library.Keep(Tried("New"));
  // The name and the seed of the episode, here none and 0.
  EXPECT_EQ(store->Experiences().front().demonstration, " 0");
}

TEST(LibraryService, DoesNotTellWhatIsOfARemovedActionOrOfOtherParts) {
  const auto store = std::make_shared<MemoryActionStore>();
  ExperienceRecord strange = Tried("New");
  strange.objects = {"thin_peg_1"};
  store->Keep(strange, kBeforeRun);
  store->Keep(Tried("Gone"), kBeforeRun);
  store->Keep(Tried("New"), kBeforeRun);
  Incarnation library(store, 0, -1);
  library.Ask("Gone");
  library.Edit(command_library_t::REMOVE, "Gone", "");
  const auto told = ExperiencesAmong(library.Request(0));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].id, 3);
  EXPECT_EQ(store->NumExperiences(), 3);
}

TEST(LibraryService, TellsWhatARenamedActionsExperiencesAreNow) {
  const auto store = std::make_shared<MemoryActionStore>();
  Incarnation library(store, 0, -1);
  library.Ask("One");
  library.Keep(Tried("One"));
  const auto told =
      ExperiencesAmong(library.Edit(command_library_t::RENAME, "One", "Two"));
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].id, 1);
  EXPECT_EQ(told[0].action, "") << "it is gone";
  EXPECT_EQ(told[1].id, 2);
  EXPECT_EQ(told[1].action, "Two");
  const auto back =
      ExperiencesAmong(library.Edit(command_library_t::ROLL_BACK, "", ""));
  ASSERT_EQ(back.size(), 1u) << "before the run there was none";
  EXPECT_EQ(back[0].id, 2);
  EXPECT_EQ(back[0].action, "");
}

TEST(LibraryService, RefusesExperiencesOfAnotherTaskAndNamesThePredicate) {
  ExperienceRecord experience = Tried("New");
  experience.before = {"DoorIsOpen(shaft)"};
  const auto store = std::make_shared<MemoryActionStore>();
  store->Keep(experience, kBeforeRun);
  try {
    Incarnation library(store, 0, -1);
    FAIL() << "took it";
  } catch (const StoreError& e) {
    EXPECT_THAT(e.what(), HasSubstr("experience 1: the task has no predicate "
                                    "'DoorIsOpen'"));
    EXPECT_THAT(e.what(), HasSubstr("name another --database"));
  }
}

TEST(LibraryService, RefusesAStoreOfAnotherTaskAndSaysWhatToDo) {
  ActionRecord record = keeping::Good("OpenDoor");
  record.arguments[0].type = "cabin_door";
  const auto store =
      std::make_shared<MemoryActionStore>(std::vector<ActionRecord>{record});
  try {
    Incarnation library(store, 0, -1);
    FAIL() << "took it";
  } catch (const StoreError& e) {
    EXPECT_THAT(e.what(), HasSubstr("action 1: OpenDoor:arguments.X"));
    EXPECT_THAT(e.what(), HasSubstr("name another --database"));
  }
}

/// In a folder of its own.
class RecordedLibrary : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = NewTestFolder();
    recorded_ = repeated_ = ShippedDeployment();
    recorded_.run_dir = dir_;
    repeated_.repeated_dir = dir_;
  }
  void TearDown() override { fs::remove_all(dir_); }

  ReplayResult Repeat() const {
    return Replay(RunLog::Load(dir_), keeping::TheRoster(), "library",
                  keeping::Factories(repeated_, kNumTicks).at("library"));
  }
  fs::path dir_;
  Deployment recorded_, repeated_;
};

TEST_F(RecordedLibrary, IsReplayedFromItsContentAtTheStartThroughDeaths) {
  RunCell(recorded_, {{"library", 50, 61}, {"library", 90, 91}});
  const ReplayResult replay = Repeat();
  EXPECT_EQ(replay.difference, std::nullopt);
  EXPECT_GT(replay.num_messages, 200);
  EXPECT_EQ(ReadContent(dir_ / kStartContentName).actions.size(), kNumOfTask);
}

TEST_F(RecordedLibrary, DiffersIfAnotherContentIsPutInItsPlace) {
  RunCell(recorded_);
  auto content = ReadContent(dir_ / kStartContentName);
  content.actions.pop_back();
  WriteContent(dir_ / kStartContentName, content);
  const ReplayResult replay = Repeat();
  ASSERT_TRUE(replay.difference);
  EXPECT_THAT(*replay.difference, HasSubstr("ACTION_RECORD"));
}

TEST_F(RecordedLibrary, GoesOnInTheNextRunWithWhatItHasLearned) {
  const fs::path database = dir_ / "kept.db";
  fs::create_directories(dir_ / "one");
  fs::create_directories(dir_ / "two");
  recorded_.run_dir = dir_ / "one";
  {
    const ActionRecord record = keeping::Good("Learned");
    OpenStore(recorded_, database)->Store({&record, 1}, 70);
  }
  recorded_.run_dir = dir_ / "two";
  { EXPECT_EQ(OpenStore(recorded_, database)->All().size(), kNumOfTask + 1); }
  EXPECT_EQ(ReadContent(dir_ / "one" / kStartContentName).actions.size(),
            kNumOfTask);
  EXPECT_EQ(ReadContent(dir_ / "two" / kStartContentName).actions.size(),
            kNumOfTask + 1);
}

}  // namespace
}  // namespace cell
