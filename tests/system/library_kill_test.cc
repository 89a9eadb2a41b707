// A process that keeps actions is killed at any moment, a thousand times: its
// file is whole, and everything that it has acknowledged is in it.
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

/// Stores without end; says each id on `pipe` once it is kept.
[[noreturn]] void StoreUntilKilled(const fs::path& file, int pipe) {
  try {
    SqliteActionStore store(file, SqliteActionStore::Mode::kCreate);
    for (auto number = static_cast<int64_t>(store.All().size()) + 1;;
         ++number) {
      const ActionRecord record = RecordOf(number);
      const int64_t id = store.Store({&record, 1}, 0).front();
      if (write(pipe, &id, sizeof(id)) != sizeof(id)) _exit(3);
    }
  } catch (const std::exception& e) {
    const std::string text = std::string(e.what()) + "\n";
    [[maybe_unused]] const auto n = write(2, text.data(), text.size());
    _exit(1);
  }
}

std::vector<int64_t> ReadIds(int pipe, int num) {
  std::vector<int64_t> ids;
  int64_t id = 0;
  while (num-- > 0 && read(pipe, &id, sizeof(id)) == sizeof(id)) {
    ids.push_back(id);
  }
  return ids;
}

/// A file that children store in, one after the other.
class KilledStore {
 public:
  explicit KilledStore(fs::path file) : file_(std::move(file)) {}

  /// Lets a child store until it has acknowledged `num` records, and `turns` of
  /// a loop longer; how many it acknowledged.
  size_t StoreAndKill(int num, uint64_t turns) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      StoreUntilKilled(file_, ends[1]);
    }
    close(ends[1]);
    std::vector<int64_t> ids = ReadIds(ends[0], num);
    for (volatile uint64_t turn = turns; turn > 0;) turn = turn - 1;
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    // What it acknowledged between the last one and the kill.
    for (const int64_t id : ReadIds(ends[0], kAll)) ids.push_back(id);
    close(ends[0]);
    for (size_t i = 0; i < ids.size(); ++i) {
      EXPECT_EQ(ids[i], num_kept_ + 1 + static_cast<int64_t>(i));
    }
    num_acknowledged_ = num_kept_ + static_cast<int64_t>(ids.size());
    return ids.size();
  }

  /// Opening checks the integrity of the file. True if the store that the kill
  /// cut short is in it nevertheless.
  bool Check() {
    const SqliteActionStore store(file_, SqliteActionStore::Mode::kCreate);
    const std::vector<ActionRecord> records = store.All();
    num_kept_ = static_cast<int64_t>(records.size());
    EXPECT_GE(num_kept_, num_acknowledged_) << "acknowledged and lost";
    EXPECT_LE(num_kept_, num_acknowledged_ + 1);
    for (int64_t id = 1; id <= num_kept_; ++id) {
      ActionRecord expected = RecordOf(id);
      expected.id = id;
      EXPECT_EQ(records[static_cast<size_t>(id) - 1], expected);
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
