// What every store of actions promises, and what the file of one does.
#include "services/library/action_store.h"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "services/library/content_json.h"
#include "services/library/memory_action_store.h"
#include "services/library/record_json.h"
#include "services/library/sqlite_action_store.h"
#include "services/library/sqlite_schema.h"
#include "tests/test_folder.h"
#include "tests/unit/library/some_experiences.h"

namespace cell {

using namespace library;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Mode = SqliteActionStore::Mode;

ActionRecord Named(const std::string& name) {
  return {0,
          1,
          name,
          {{"X", "bolt"}, {"Y", "hole"}},
          {"person", "robot"},
          "",
          "moved: X",
          "- context: []",
          "",
          "name: insert",
          "insertion"};
}

int64_t StoreOne(ActionStore& store, const std::string& name, int32_t tick) {
  const ActionRecord record = Named(name);
  return store.Store({&record, 1}, tick).front();
}

std::vector<std::string> NamesIn(const ActionStore& store) {
  std::vector<std::string> names;
  for (const ActionRecord& record : store.All()) names.push_back(record.name);
  return names;
}

class StoreFile : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = NewTestFolder();
    file_ = dir_ / "library.db";
  }
  void TearDown() override { fs::remove_all(dir_); }

  std::string Complaint() const {
    try {
      SqliteActionStore store(file_, Mode::kCreate);
      return "none";
    } catch (const StoreError& e) {
      return e.what();
    }
  }
  std::string Bytes() const {
    std::ifstream stream(file_);
    std::stringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
  }

  fs::path dir_, file_;
};

/// The same tests on both.
class Contract : public StoreFile, public testing::WithParamInterface<bool> {
 protected:
  void SetUp() override {
    StoreFile::SetUp();
    if (GetParam()) {
      store_ = std::make_unique<SqliteActionStore>(file_, Mode::kCreate);
    } else {
      store_ = std::make_unique<MemoryActionStore>();
    }
  }
  std::unique_ptr<ActionStore> store_;
};

INSTANTIATE_TEST_SUITE_P(Stores, Contract, testing::Bool(),
                         [](const auto& which) {
                           return which.param ? "Sqlite" : "Memory";
                         });

TEST_P(Contract, IsEmptyAtFirst) {
  EXPECT_THAT(store_->All(), IsEmpty());
  EXPECT_EQ(store_->Find(1), std::nullopt);
  EXPECT_EQ(store_->FindNamed("Insert"), std::nullopt);
}

TEST_P(Contract, GivesIdsInTheOrderOfStoringAndKeepsEveryWord) {
  ActionRecord odd = Named("Odd");
  odd.id = 77;  // does not count
  odd.rules = "- context: [\"a 'quoted' thing\", \u00e4]\n\t\"\\ '; --";
  EXPECT_EQ(StoreOne(*store_, "Insert", 3), 1);
  EXPECT_THAT(store_->Store({&odd, 1}, 4), ElementsAre(2));
  odd.id = 2;
  EXPECT_EQ(store_->Find(2), odd);
  EXPECT_EQ(store_->FindNamed("Odd"), odd);
  EXPECT_THAT(NamesIn(*store_), ElementsAre("Insert", "Odd"));
  EXPECT_EQ(store_->Count(), 2);
  EXPECT_EQ(store_->Find(3), std::nullopt);
  EXPECT_EQ(store_->Find(-1), std::nullopt);
}

TEST_P(Contract, KeepsAllOfThemOrNone) {
  StoreOne(*store_, "Insert", 0);
  const std::vector<ActionRecord> records = {Named("New"), Named("Insert")};
  EXPECT_THROW(store_->Store(records, 1), std::invalid_argument);
  EXPECT_THAT(NamesIn(*store_), ElementsAre("Insert"));
  EXPECT_EQ(StoreOne(*store_, "New", 1), 2);
}

TEST_P(Contract, RollsBackWhatWasStoredFromATickOnAndReusesItsIds) {
  StoreOne(*store_, "Before", kBeforeRun);
  for (int32_t tick = 1; tick <= 4; ++tick) {
    StoreOne(*store_, "In" + std::to_string(tick), tick);
  }
  store_->RollBackTo(3);
  EXPECT_THAT(NamesIn(*store_), ElementsAre("Before", "In1", "In2"));
  EXPECT_EQ(StoreOne(*store_, "Other", 5), 4);
}

TEST_P(Contract, ARunThatBeginsKeepsAllThatIsThere) {
  StoreOne(*store_, "Insert", 500);
  store_->BeginRun();
  StoreOne(*store_, "Remove", 20);
  store_->RollBackTo(10);
  EXPECT_THAT(NamesIn(*store_), ElementsAre("Insert"));
}

TEST_P(Contract, ReplacesARecordByOneOfAHigherVersion) {
  StoreOne(*store_, "Insert", kBeforeRun);
  StoreOne(*store_, "Remove", kBeforeRun);
  ActionRecord next = Named("Insert");
  EXPECT_THROW(store_->Store({&next, 1}, 4), std::invalid_argument);
  next.version = 2;
  next.rules = "- other";
  EXPECT_THAT(store_->Store({&next, 1}, 4), ElementsAre(3));
  EXPECT_THAT(NamesIn(*store_), ElementsAre("Remove", "Insert"));
  EXPECT_EQ(store_->Count(), 2);
  EXPECT_EQ(store_->FindNamed("Insert")->rules, "- other");
  store_->RollBackTo(4);
  EXPECT_EQ(*store_->FindNamed("Insert"), *store_->Find(1));
  store_->Store({&next, 1}, 5);
  store_->BeginRun();
  EXPECT_EQ(store_->Find(1), std::nullopt);
  EXPECT_EQ(store_->FindNamed("Insert")->version, 2);
}

TEST_P(Contract, KeepsWhatItHeldBeforeEachChange) {
  EXPECT_THAT(store_->Changes(), IsEmpty());
  StoreOne(*store_, "Insert", kBeforeRun);
  store_->BeginChange("idle");
  store_->BeginChange("run 1");
  const int64_t id = StoreOne(*store_, "Remove", 3);
  store_->BeginChange("run 2");
  ASSERT_EQ(store_->Changes().size(), 2u);
  EXPECT_EQ(store_->Changes()[0].number, 1);
  EXPECT_EQ(store_->Changes()[0].what, "run 1");
  EXPECT_NE(store_->Changes()[0].build, "");
  EXPECT_EQ(store_->Changes()[1].what, "run 2");
  EXPECT_EQ(store_->ChangeOf(id)->what, "run 1");
  EXPECT_EQ(store_->ChangeOf(1), std::nullopt);
  ASSERT_EQ(store_->ContentBefore(1)->actions.size(), 1u);
  EXPECT_EQ(store_->ContentBefore(1)->actions.front().name, "Insert");
  EXPECT_EQ(store_->ContentBefore(2)->actions.size(), 2u);
  EXPECT_FALSE(store_->ContentBefore(3));
}

TEST_P(Contract, KeepsTheLastChangesOnly) {
  for (int64_t i = 0; i <= ActionStore::kMaxChanges; ++i) {
    store_->BeginChange("change " + std::to_string(i));
    StoreOne(*store_, "A" + std::to_string(i), kBeforeRun);
  }
  const auto changes = store_->Changes();
  ASSERT_EQ(static_cast<int64_t>(changes.size()), ActionStore::kMaxChanges);
  EXPECT_EQ(changes.front().number, 2);
  EXPECT_EQ(changes.back().number, ActionStore::kMaxChanges + 1);
}

TEST_P(Contract, TellsWhatWasThereBeforeTheRun) {
  StoreOne(*store_, "Insert", kBeforeRun);
  ActionRecord next = Named("Insert");
  next.version = 2;
  store_->Store({&next, 1}, 4);
  StoreOne(*store_, "Remove", 5);
  ASSERT_EQ(store_->BeforeRun().actions.size(), 1u);
  EXPECT_EQ(store_->BeforeRun().actions[0].version, 1);
  store_->BeginRun();
  EXPECT_EQ(store_->BeforeRun().actions, store_->All());
}

std::vector<std::string> ExperiencesIn(
    const std::vector<ExperienceRecord>& experiences) {
  std::vector<std::string> texts;
  for (const ExperienceRecord& experience : experiences) {
    texts.push_back(std::to_string(experience.id) + " " + experience.action);
  }
  return texts;
}

TEST_P(Contract, KeepsExperiencesAsTheyWereInTheOrderOfStoring) {
  EXPECT_EQ(store_->NumExperiences(), 0);
  ExperienceRecord first = Tried("Nobody's", 3);
  first.id = 88;  // does not count
  EXPECT_EQ(store_->Keep(first, 1), 1);
  EXPECT_EQ(store_->Keep(first, 1), 2);  // the same again
  EXPECT_EQ(store_->Keep(Tried("B"), 2), 3);
  first.id = 1;
  EXPECT_EQ(store_->Experiences().front(), first);
  EXPECT_THAT(ExperiencesIn(store_->ExperiencesFrom(2, 1)),
              ElementsAre("2 Nobody's"));
  EXPECT_THAT(ExperiencesIn(store_->ExperiencesFrom(2, 100)),
              ElementsAre("2 Nobody's", "3 B"));
  EXPECT_EQ(store_->NumExperiences(), 3);
  EXPECT_EQ(store_->Content().last_experience, 3);
}

TEST_P(Contract, AppliesAnEditAsAWholeOrNotAtAll) {
  store_->Keep(Tried("A"), 1);
  const StoreEdit no_such{.records = {Named("Insert")},
                          .experiences = {Tried("B")},
                          .removed_experiences = {1, 2}};
  EXPECT_THROW(store_->Apply(no_such, 2), std::invalid_argument);
  EXPECT_EQ(store_->Count(), 0);
  EXPECT_THAT(ExperiencesIn(store_->Experiences()), ElementsAre("1 A"));
  const StoreEdit edit{.records = {Named("Insert")},
                       .experiences = {Tried("B"), Tried("C")},
                       .removed_experiences = {1}};
  const StoredIds ids = store_->Apply(edit, 2);
  EXPECT_THAT(ids.records, ElementsAre(1));
  EXPECT_THAT(ids.experiences, ElementsAre(2, 3));
  EXPECT_THAT(ExperiencesIn(store_->Experiences()), ElementsAre("2 B", "3 C"));
  EXPECT_EQ(store_->NumExperiences(), 2);
  EXPECT_THROW(store_->Apply({.removed_experiences = {1}}, 3),
               std::invalid_argument);
}

TEST_P(Contract, RollsBackExperiencesAndTheirRemoval) {
  store_->Keep(Tried("Before"), kBeforeRun);
  store_->Keep(Tried("In1"), 1);
  store_->Apply({.removed_experiences = {1}}, 2);
  store_->Keep(Tried("In3"), 3);
  EXPECT_THAT(ExperiencesIn(store_->BeforeRun().experiences),
              ElementsAre("1 Before"));
  store_->RollBackTo(3);
  EXPECT_THAT(ExperiencesIn(store_->Experiences()), ElementsAre("2 In1"));
  store_->RollBackTo(2);
  EXPECT_THAT(ExperiencesIn(store_->Experiences()),
              ElementsAre("1 Before", "2 In1"));
  EXPECT_EQ(store_->Keep(Tried("Other"), 4), 3);
}

TEST_P(Contract, ARunThatBeginsKeepsAllExperiencesAndRemovals) {
  store_->Keep(Tried("A"), 400);
  store_->Keep(Tried("B"), 500);
  store_->Apply({.removed_experiences = {1}}, 600);
  store_->BeginRun();
  store_->Keep(Tried("C"), 20);
  store_->RollBackTo(10);
  EXPECT_THAT(ExperiencesIn(store_->Experiences()), ElementsAre("2 B"));
  EXPECT_THAT(ExperiencesIn(store_->BeforeRun().experiences),
              ElementsAre("2 B"));
}

TEST_P(Contract, KeepsTheExperiencesBeforeEachChange) {
  store_->Keep(Tried("A"), kBeforeRun);
  store_->BeginChange("run 1");
  store_->Keep(Tried("B"), 3);
  store_->BeginChange("take back");
  store_->Apply({.removed_experiences = {1}}, kBeforeRun);
  store_->BeginChange("run 2");
  ASSERT_EQ(store_->Changes().size(), 3u);
  EXPECT_THAT(ExperiencesIn(store_->ContentBefore(1)->experiences),
              ElementsAre("1 A"));
  EXPECT_THAT(ExperiencesIn(store_->ContentBefore(2)->experiences),
              ElementsAre("1 A", "2 B"));
  EXPECT_THAT(ExperiencesIn(store_->ContentBefore(3)->experiences),
              ElementsAre("2 B"));
}

TEST_P(Contract, OfItsContentIsTheSameWithTheSameIds) {
  for (const char* name : {"A", "B", "C"}) store_->Keep(Tried(name), 1);
  store_->Apply({.removed_experiences = {1, 3}}, 2);
  StoreOne(*store_, "Insert", 1);
  ActionRecord next = Named("Insert");
  next.version = 2;
  store_->Store({&next, 1}, 3);
  MemoryActionStore copy(store_->Content());
  EXPECT_EQ(copy.All(), store_->All());
  EXPECT_EQ(copy.Experiences(), store_->Experiences());
  EXPECT_EQ(StoreOne(copy, "Remove", 4), StoreOne(*store_, "Remove", 4));
  EXPECT_EQ(copy.Keep(Tried("D"), 4), store_->Keep(Tried("D"), 4));
}

using SqliteFile = StoreFile;

TEST_F(SqliteFile, OfTheThirdSchemaHasNoExperiencesAndTakesThem) {
  {
    SQLite::Database database(file_.string(),
                              SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    Migrate(database, LibrarySchema().first(3));
    ActionRecord record = Named("Insert");
    record.id = 1;
    SQLite::Statement insert(
        database, "INSERT INTO action VALUES (1, 'Insert', 1, ?, -1, 0)");
    insert.bind(1, JsonOf(record));
    insert.exec();
  }
  {
    SqliteActionStore store(file_, Mode::kExisting);
    EXPECT_THAT(NamesIn(store), ElementsAre("Insert"));
    EXPECT_EQ(store.NumExperiences(), 0);
    store.Keep(Tried("Insert"), 7);
  }
  const SqliteActionStore store(file_, Mode::kExisting);
  EXPECT_THAT(ExperiencesIn(store.Content().experiences),
              ElementsAre("1 Insert"));
}

TEST_F(SqliteFile, HasItsExperiencesInTheNextProcessWithTheirTicks) {
  {
    SqliteActionStore store(file_, Mode::kCreate);
    store.Keep(Tried("A"), 5);
    store.Keep(Tried("B"), 6);
    store.Apply({.removed_experiences = {1}}, 7);
  }
  SqliteActionStore store(file_, Mode::kExisting);
  EXPECT_THAT(ExperiencesIn(store.Content().experiences), ElementsAre("2 B"));
  store.RollBackTo(6);
  EXPECT_THAT(ExperiencesIn(store.Content().experiences), ElementsAre("1 A"));
}

TEST_F(SqliteFile, ForgetsWhatWasRemovedBeforeTheLastChanges) {
  SqliteActionStore store(file_, Mode::kCreate);
  store.BeginChange("first");
  store.Keep(Tried("A"), kBeforeRun);
  store.Apply({.removed_experiences = {1}}, kBeforeRun);
  const auto num_kept = [&] {
    return store.ContentBefore(store.Changes().front().number)
        ->experiences.size();
  };
  for (int64_t i = 0; i < ActionStore::kMaxChanges; ++i) {
    store.BeginChange("change " + std::to_string(i));
    store.Keep(Tried("B"), kBeforeRun);
  }
  EXPECT_EQ(num_kept(), 0u);
  EXPECT_EQ(store.NumExperiences(), ActionStore::kMaxChanges);
}

TEST_F(SqliteFile, WithAnExperienceThatCannotBeReadNamesIt) {
  {
    SqliteActionStore store(file_, Mode::kCreate);
    store.Keep(Tried("A"), 0);
  }
  {
    SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
    database.exec("UPDATE experience SET experience = '{\"id\": 1}'");
  }
  const SqliteActionStore store(file_, Mode::kExisting);
  try {
    store.Content();
    FAIL() << "read it";
  } catch (const StoreError& e) {
    EXPECT_THAT(e.what(), HasSubstr("library.db:experience 1.action: missing; "
                                    "the file is damaged"));
  }
}

/// A write that was cut short: the end of the file is missing.
TEST_F(SqliteFile, ThatIsCutShortIsNamedWithTheFix) {
  {
    SqliteActionStore store(file_, Mode::kCreate);
    for (int i = 0; i < 200; ++i) store.Keep(Tried("A", i), 0);
  }
  const std::string whole = Bytes();
  for (const size_t size : {whole.size() / 2, whole.size() - 1000}) {
    std::ofstream(file_, std::ios::binary) << whole.substr(0, size);
    EXPECT_THAT(Complaint(), HasSubstr(file_.string() + ": is damaged"));
  }
}

TEST_F(SqliteFile, IsReadAgainByTheNextProcessWithItsTicks) {
  {
    SqliteActionStore store(file_, Mode::kCreate);
    StoreOne(store, "Insert", 5);
    StoreOne(store, "Remove", 6);
  }
  SqliteActionStore store(file_, Mode::kExisting);
  EXPECT_THAT(NamesIn(store), ElementsAre("Insert", "Remove"));
  store.RollBackTo(6);
  EXPECT_THAT(NamesIn(store), ElementsAre("Insert"));
  EXPECT_EQ(store.schema_version(), static_cast<int>(LibrarySchema().size()));
}

TEST_F(SqliteFile, OfTheFirstSchemaIsReadWithTheFirstVersion) {
  ActionRecord record = Named("Insert");
  record.id = 1;
  std::string json = JsonOf(record);
  const std::string of_record = "\"version\":1,";
  json.erase(json.find(of_record), of_record.size());
  {
    SQLite::Database database(file_.string(),
                              SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    Migrate(database, LibrarySchema().first(1));
    SQLite::Statement insert(database,
                             "INSERT INTO action VALUES (1, 'Insert', ?, -1)");
    insert.bind(1, json);
    insert.exec();
  }
  SqliteActionStore store(file_, Mode::kExisting);
  EXPECT_EQ(store.FindNamed("Insert"), record);
}

TEST_F(SqliteFile, WritesAhead) {
  SqliteActionStore store(file_, Mode::kCreate);
  StoreOne(store, "Insert", 0);
  EXPECT_TRUE(fs::exists(file_.string() + "-wal"));
}

TEST_F(SqliteFile, HasOneOwner) {
  SqliteActionStore store(file_, Mode::kCreate);
  const std::string complaint = Complaint();
  EXPECT_THAT(complaint, HasSubstr(file_.string()));
  EXPECT_THAT(complaint, HasSubstr("another process owns it"));
}

TEST_F(SqliteFile, IsNotMadeIfItMustBeThere) {
  EXPECT_THROW(SqliteActionStore(file_, Mode::kExisting), StoreError);
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(SqliteFile, OfANewerSchemaIsLeftAsItIs) {
  {
    SQLite::Database database(file_.string(),
                              SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    Migrate(database, LibrarySchema());
    database.exec("PRAGMA user_version = 99");
  }
  const std::string before = Bytes();
  EXPECT_THAT(Complaint(), HasSubstr("has schema 99, newer than"));
  EXPECT_THAT(Complaint(), HasSubstr("use the build of the cell that wrote"));
  EXPECT_EQ(Bytes(), before);
}

TEST_F(SqliteFile, OfANewerSchemaNamesTheBuildThatReadsIt) {
  {
    SQLite::Database database(file_.string(),
                              SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    Migrate(database, LibrarySchema());
    database.exec("PRAGMA user_version = 99");
    database.exec("INSERT INTO change VALUES (4, 'a run', '7.2.0', '')");
  }
  EXPECT_THAT(Complaint(), HasSubstr("; use build 7.2.0, or a newer one"));
}

TEST_F(SqliteFile, OfAnotherProgramIsLeftAsItIs) {
  {
    SQLite::Database database(file_.string(),
                              SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec("CREATE TABLE recipe (name TEXT)");
  }
  const std::string before = Bytes();
  EXPECT_THAT(Complaint(), HasSubstr("is the database of another program"));
  EXPECT_EQ(Bytes(), before);
}

TEST_F(SqliteFile, OfNoDatabaseIsLeftAsItIs) {
  std::ofstream(file_) << std::string(5000, 'x');
  EXPECT_THAT(Complaint(), HasSubstr("is not an SQLite database"));
  EXPECT_EQ(Bytes(), std::string(5000, 'x'));
}

TEST_F(SqliteFile, ThatIsDamagedIsNamedWithTheFix) {
  {
    SqliteActionStore store(file_, Mode::kCreate);
    for (int i = 0; i < 200; ++i) StoreOne(store, "A" + std::to_string(i), 0);
  }
  std::fstream stream(file_, std::ios::in | std::ios::out);
  for (int page = 1; page < 8; ++page) {  // all but the first: of tables
    stream.seekp(4096 * page + 8);
    stream << std::string(64, '\x55');
  }
  stream.close();
  const std::string complaint = Complaint();
  EXPECT_THAT(complaint, HasSubstr(file_.string() + ": is damaged"));
  EXPECT_THAT(complaint, HasSubstr("cell library import"));
}

TEST_F(SqliteFile, WithARecordThatCannotBeReadNamesIt) {
  {
    SqliteActionStore store(file_, Mode::kCreate);
    StoreOne(store, "Insert", 0);
  }
  {
    SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
    database.exec("UPDATE action SET record = '{\"id\": 1}'");
  }
  SqliteActionStore store(file_, Mode::kExisting);
  try {
    store.All();
    FAIL() << "read it";
  } catch (const StoreError& e) {
    EXPECT_THAT(e.what(), HasSubstr("action 1.version: missing"));
  }
}

TEST_F(SqliteFile, ThatMayNotBeWrittenSaysSo) {
  { SqliteActionStore store(file_, Mode::kCreate); }
  using fs::perms;
  constexpr perms kRead = perms::owner_read | perms::others_read;
  constexpr perms kEnter = perms::owner_exec | perms::others_exec;
  constexpr perms kWrite = perms::owner_write | perms::others_write;
  const bool is_root = geteuid() == 0;
  constexpr uid_t kNobody = 65534;
  const auto complaint = [&](perms of_file, perms of_folder) {
    fs::permissions(file_, of_file);
    fs::permissions(dir_, of_folder);
    if (is_root && seteuid(kNobody) != 0) return std::string("is still root");
    const std::string text = Complaint();
    if (is_root && seteuid(0) != 0) return std::string("is not root again");
    fs::permissions(dir_, perms::owner_all);
    return text;
  };
  EXPECT_THAT(complaint(kRead | kWrite, kRead | kEnter),
              HasSubstr("may this user write to both?"));
  EXPECT_THAT(complaint(kRead, kRead | kEnter | kWrite),
              HasSubstr("may this user write to both?"));
}

TEST_F(SqliteFile, InAFolderThatIsNotThereSaysSo) {
  file_ = dir_ / "nowhere" / "library.db";
  EXPECT_THAT(Complaint(), HasSubstr("do file and folder exist"));
}

// Schemas to come: each step keeps what was stored under the one before.
class Migration : public StoreFile {
 protected:
  Migration()
      : database_(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) {}

  static constexpr const char* kFirst = "CREATE TABLE a (x INTEGER)";
  static constexpr const char* kSecond =
      "ALTER TABLE a ADD COLUMN y TEXT DEFAULT 'old'";
  static constexpr const char* kBroken =
      "CREATE TABLE b (z INTEGER); CREATE TABLE a (x INTEGER)";

  std::string RowText() {
    SQLite::Statement row(database_, "SELECT x || y FROM a");
    return row.executeStep() ? row.getColumn(0).getString() : "";
  }
  SQLite::Database database_;
};

TEST_F(Migration, TakesTheStepsThatAreMissingAndKeepsTheContent) {
  const char* const first[] = {kFirst};
  Migrate(database_, first);
  EXPECT_EQ(SchemaVersion(database_, 2), 1);
  database_.exec("INSERT INTO a VALUES (7)");
  const char* const both[] = {kFirst, kSecond};
  Migrate(database_, both);
  EXPECT_EQ(SchemaVersion(database_, 2), 2);
  EXPECT_EQ(RowText(), "7old");
  Migrate(database_, both);  // changes nothing
  EXPECT_EQ(RowText(), "7old");
  EXPECT_THROW(Migrate(database_, first), std::invalid_argument);
}

TEST_F(Migration, ThatFailsChangesNothing) {
  const char* const first[] = {kFirst};
  Migrate(database_, first);
  const char* const broken[] = {kFirst, kSecond, kBroken};
  EXPECT_THROW(Migrate(database_, broken), SQLite::Exception);
  EXPECT_EQ(SchemaVersion(database_, 3), 1);
  SQLite::Statement tables(database_, "SELECT count(*) FROM sqlite_schema");
  ASSERT_TRUE(tables.executeStep());
  EXPECT_EQ(tables.getColumn(0).getInt(), 1);
}

}  // namespace
}  // namespace cell
