// A process that keeps actions and experiences is killed at any moment, a
// thousand times: its file is whole, and everything that it has acknowledged is
// in it.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <random>

#include "services/library/sqlite_action_store.h"
#include "tests/test_folder.h"

namespace cell {

using namespace library;
namespace {

namespace fs = std::filesystem;

constexpr int kNumKills = 1000;
constexpr int kKillsPerFile = 25;
constexpr int kMaxAcknowledged = 4;  // before a kill
/// The kill comes so many turns of a loop later at most: somewhere within the
/// next store, whatever the machine.
constexpr uint32_t kMaxTurns = 400'000;

ActionRecord RecordOf(int64_t number) {
  ActionRecord record;
  record.name = "Action" + std::to_string(number);
  record.arguments = {{"X", "thing"}};
  record.agents = {"person"};
  // Of many sizes, some over several pages.
  record.rules = std::string(static_cast<size_t>(number % 7) * 1500, 'r') +
                 std::to_string(number);
  return record;
}

ExperienceRecord ExperienceOf(int64_t number) {
  ExperienceRecord experience;
  experience.action = "Action" + std::to_string(number);
  experience.agent = "person";
  // Of many sizes, some over several pages.
  experience.before.assign(static_cast<size_t>(number % 5) * 100,
                           "On(a, b" + std::to_string(number) + ")");
  experience.after = {"?Clear(a)"};
  return experience;
}

/// Keeps an action if the number is odd, else an experience.
void Store(ActionStore& store, int64_t number) {
  if (number % 2 == 0) {
    store.Keep(ExperienceOf(number / 2), 0);
  } else {
    const ActionRecord record = RecordOf((number + 1) / 2);
    store.Store({&record, 1}, 0);
  }
}

/// Stores without end; says each number on `pipe` once it is kept.
[[noreturn]] void StoreUntilKilled(const fs::path& file, int pipe) {
  try {
    SqliteActionStore store(file, SqliteActionStore::Mode::kCreate);
    for (int64_t number = store.Count() + store.NumExperiences() + 1;;
         ++number) {
      Store(store, number);
      if (write(pipe, &number, sizeof(number)) != sizeof(number)) _exit(3);
    }
  } catch (const std::exception& e) {
    const std::string text = std::string(e.what()) + "\n";
    [[maybe_unused]] const auto n = write(2, text.data(), text.size());
    _exit(1);
  }
}

std::vector<int64_t> ReadNumbers(int pipe, int num) {
  std::vector<int64_t> numbers;
  int64_t number = 0;
  while (num-- > 0 && read(pipe, &number, sizeof(number)) == sizeof(number)) {
    numbers.push_back(number);
  }
  return numbers;
}

/// A file that children store in, one after the other.
class KilledStore {
 public:
  explicit KilledStore(fs::path file) : file_(std::move(file)) {}

  /// Lets a child store until it has acknowledged `num` times, and `turns` of a
  /// loop longer; how many it acknowledged.
  size_t StoreAndKill(int num, uint64_t turns) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      StoreUntilKilled(file_, ends[1]);
    }
    close(ends[1]);
    std::vector<int64_t> numbers = ReadNumbers(ends[0], num);
    for (volatile uint64_t turn = turns; turn > 0;) turn = turn - 1;
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    // What it acknowledged between the last one and the kill.
    for (const int64_t number : ReadNumbers(ends[0], kAll)) {
      numbers.push_back(number);
    }
    close(ends[0]);
    for (size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_EQ(numbers[i], num_kept_ + 1 + static_cast<int64_t>(i));
    }
    num_acknowledged_ = num_kept_ + static_cast<int64_t>(numbers.size());
    return numbers.size();
  }

  /// Opening checks the integrity of the file. True if the store that the kill
  /// cut short is in it nevertheless.
  bool Check() {
    const SqliteActionStore store(file_, SqliteActionStore::Mode::kCreate);
    const LibraryContent content = store.Content();
    const auto num_experiences =
        static_cast<int64_t>(content.experiences.size());
    num_kept_ = static_cast<int64_t>(content.actions.size()) + num_experiences;
    EXPECT_EQ(num_experiences, num_kept_ / 2);
    EXPECT_GE(num_kept_, num_acknowledged_) << "acknowledged and lost";
    EXPECT_LE(num_kept_, num_acknowledged_ + 1);
    for (size_t i = 0; i < content.actions.size(); ++i) {
      ActionRecord expected = RecordOf(static_cast<int64_t>(i) + 1);
      expected.id = static_cast<int64_t>(i) + 1;
      EXPECT_EQ(content.actions[i], expected);
    }
    for (size_t i = 0; i < content.experiences.size(); ++i) {
      ExperienceRecord expected = ExperienceOf(static_cast<int64_t>(i) + 1);
      expected.id = static_cast<int64_t>(i) + 1;
      EXPECT_EQ(content.experiences[i], expected);
    }
    return num_kept_ > num_acknowledged_;
  }

 private:
  static constexpr int kAll = 1'000'000;

  fs::path file_;
  int64_t num_kept_ = 0;  // as last seen
  int64_t num_acknowledged_ = 0;
};

TEST(LibraryKill, AThousandTimesCorruptsNothingAndLosesNothingAcknowledged) {
  const fs::path dir = NewTestFolder();
  std::mt19937 random(7);
  size_t num_acknowledged = 0;
  int num_cut_short = 0;
  for (int i = 0; i < kNumKills / kKillsPerFile; ++i) {
    fs::remove_all(dir);
    fs::create_directories(dir);
    KilledStore store(dir / "library.db");
    for (int j = 0; j < kKillsPerFile; ++j) {
      const int num = static_cast<int>(random() % (kMaxAcknowledged + 1));
      num_acknowledged += store.StoreAndKill(num, random() % kMaxTurns);
      num_cut_short += store.Check();
      ASSERT_FALSE(HasFailure()) << "at kill " << j << " of file " << i;
    }
  }
  RecordProperty("acknowledged", static_cast<int>(num_acknowledged));
  RecordProperty("kept_unacknowledged", num_cut_short);
  EXPECT_GT(num_acknowledged, static_cast<size_t>(kNumKills));
  fs::remove_all(dir);
}

}  // namespace
}  // namespace cell
