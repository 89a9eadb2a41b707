// What a person may change in a library: all of it or nothing, and nothing that
// was kept before is overwritten.
#include "services/library/record_edits.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "common/actions/action_model_reader.h"
#include "common/actions/action_model_writer.h"
#include "services/library/memory_action_store.h"
#include "services/library/sqlite_action_store.h"
#include "tests/test_folder.h"
#include "tests/unit/library/some_experiences.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace library;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class RecordEditsTest : public testing::Test {
 protected:
  RecordEdits Edits() {
    content_ = store_.Content();
    return {content_, task_.domain, task_.parts};
  }
  /// Stores them as a library would; "" or why not.
  std::string Apply(const Result<StoreEdit>& edit) {
    if (!edit) return edit.reason();
    if (const auto why = WhyNotAll(edit->records, check_, store_);
        !why.empty()) {
      return why;
    }
    store_.Apply(*edit, kBeforeRun);
    return "";
  }
  ActionRecord Of(const std::string& name) const {
    return store_.FindNamed(name).value_or(ActionRecord{});
  }

  const ShippedTask task_;
  const RecordCheck check_ = RecordCheck::FromTask(ShippedDeployment());
  MemoryActionStore store_{WriteActionModels(task_.actions, task_.domain)};
  LibraryContent content_;
};

TEST_F(RecordEditsTest, ARenamedActionIsTheSameUnderItsNewName) {
  const ActionRecord before = Of("PlaceSeparator");
  EXPECT_EQ(Apply(Edits().Rename("PlaceSeparator", "Divide")), "");
  ActionRecord after = Of("Divide");
  EXPECT_EQ(after.version, 1);
  after.name = before.name;
  after.id = before.id;
  EXPECT_EQ(after, before);
  EXPECT_TRUE(Of("PlaceSeparator").is_removed());
  EXPECT_EQ(Of("PlaceSeparator").version, 2);
  EXPECT_EQ(Of("RemoveSeparator").undoes, "Divide");
}

/// "3 Divide" for each experience.
std::vector<std::string> ExperiencesOf(const ActionStore& store) {
  std::vector<std::string> texts;
  for (const ExperienceRecord& experience : store.Experiences()) {
    texts.push_back(std::to_string(experience.id) + " " + experience.action);
  }
  return texts;
}

TEST_F(RecordEditsTest, ExperiencesOfARenamedActionHaveItsNewName) {
  store_.Keep(Tried("PlaceSeparator", 1), kBeforeRun);
  store_.Keep(Tried("Raise", 2), kBeforeRun);
  EXPECT_EQ(Apply(Edits().Rename("PlaceSeparator", "Divide")), "");
  EXPECT_THAT(ExperiencesOf(store_), ElementsAre("2 Raise", "3 Divide"));
  ExperienceRecord moved = Tried("Divide", 1);
  moved.id = 3;
  EXPECT_EQ(store_.ExperiencesFrom(3, 100).front(), moved);
}

TEST_F(RecordEditsTest, ExperiencesOfAMergedActionAreTheOthers) {
  ActionRecord copy = Of("PlaceRoundPeg");
  copy.name = "Action7";
  copy.id = 0;
  ASSERT_EQ(Apply(StoreEdit{.records = {copy}}), "");
  store_.Keep(Tried("Action7"), kBeforeRun);
  EXPECT_EQ(Apply(Edits().Merge("Action7", "PlaceRoundPeg")), "");
  EXPECT_THAT(ExperiencesOf(store_), ElementsAre("2 PlaceRoundPeg"));
}

TEST_F(RecordEditsTest, ARemovedActionsExperiencesAreKept) {
  store_.Keep(Tried("Raise"), kBeforeRun);
  EXPECT_EQ(Apply(Edits().Remove("Raise")), "");
  EXPECT_THAT(ExperiencesOf(store_), ElementsAre("1 Raise"));
}

TEST_F(RecordEditsTest, TakesBackWhatPeopleDidInADemonstration) {
  for (int i = 1; i <= 4; ++i) {  // by an arm: 3
    ExperienceRecord experience = Tried("Raise", i);
    experience.demonstration = i == 1 ? "other 1" : "strange 9";
    store_.Keep(experience, kBeforeRun);
  }
  EXPECT_EQ(Apply(Edits().TakeBack("strange 9")), "");
  EXPECT_THAT(ExperiencesOf(store_), ElementsAre("1 Raise", "3 Raise"));
  EXPECT_THAT(Apply(Edits().TakeBack("strange 9")),
              HasSubstr("'strange 9' has taught nothing"));
}

TEST_F(RecordEditsTest, ARollBackRestoresTheExperiences) {
  store_.Keep(Tried("Raise", 1), kBeforeRun);
  store_.Keep(Tried("Raise", 1), kBeforeRun);  // the same again
  store_.Keep(Tried("PlaceSeparator", 2), kBeforeRun);
  const LibraryContent start = store_.Content();
  EXPECT_EQ(Apply(Edits().Rename("PlaceSeparator", "Divide")), "");
  store_.Keep(Tried("Raise", 3), kBeforeRun);
  store_.Apply({.removed_experiences = {1}}, kBeforeRun);
  EXPECT_EQ(Apply(Edits().Restore(start)), "");
  std::vector<ExperienceRecord> restored = store_.Experiences();
  ASSERT_EQ(restored.size(), start.experiences.size());
  for (const ExperienceRecord& before : start.experiences) {
    const auto same = std::ranges::find_if(restored, [&](auto experience) {
      experience.id = before.id;
      return experience == before;
    });
    ASSERT_NE(same, restored.end());
    restored.erase(same);
  }
  EXPECT_THAT(Apply(Edits().Restore(start)), HasSubstr("already holds that"));
}

TEST_F(RecordEditsTest, ANameThatIsTakenIsRefused) {
  EXPECT_THAT(Apply(Edits().Rename("Raise", "ScrewHead")),
              HasSubstr("'ScrewHead' already exists"));
  EXPECT_THAT(Apply(Edits().Rename("Raise", "Raise it")),
              HasSubstr("its name should be a letter"));
  EXPECT_THAT(Apply(Edits().Rename("Rise", "Lift")),
              HasSubstr("there is no action 'Rise'"));
  EXPECT_FALSE(Of("Raise").is_removed());
}

TEST_F(RecordEditsTest, ARemovedActionStaysKnownByItsNameAndCanComeBack) {
  const ActionRecord before = Of("Raise");
  EXPECT_EQ(Apply(Edits().Remove("Raise")), "");
  EXPECT_TRUE(Of("Raise").is_removed());
  const Action removed = ReadAction(Of("Raise"), task_.domain);
  EXPECT_THAT(removed.agents, IsEmpty());
  EXPECT_THAT(removed.rules, IsEmpty());
  EXPECT_THAT(Apply(Edits().Remove("Raise")), HasSubstr("there is no action"));
  LibraryContent earlier = store_.Content();
  std::ranges::replace_if(
      earlier.actions, [](const auto& r) { return r.name == "Raise"; }, before);
  EXPECT_EQ(Apply(Edits().Restore(earlier)), "");
  EXPECT_EQ(Of("Raise").sec, before.sec);
  EXPECT_EQ(Of("Raise").version, 3);
}

TEST_F(RecordEditsTest, WhatIsUndoneByAnotherIsRemovedAfterIt) {
  EXPECT_THAT(Apply(Edits().Remove("ScrewHead")),
              HasSubstr("'RemoveHead' undoes it; remove that first"));
  EXPECT_EQ(Apply(Edits().Remove("RemoveHead")), "");
  EXPECT_EQ(Apply(Edits().Remove("ScrewHead")), "");
}

TEST_F(RecordEditsTest, ARecordWithoutAgentsMaySayNothingElse) {
  ActionRecord record = Of("Raise");
  record.id = 0;
  ++record.version;
  record.agents.clear();
  EXPECT_THAT(check_.WhyNot(record, store_)->reason,
              HasSubstr("Raise:agents: names no agent"));
}

TEST_F(RecordEditsTest, MergesWhatWasLearnedOfActionsThatShareAChange) {
  ActionRecord copy = Of("PlaceRoundPeg");
  copy.name = "Action7";
  copy.id = 0;
  ASSERT_EQ(Apply(StoreEdit{.records = {copy}}), "");
  EXPECT_THAT(Apply(Edits().Merge("Action7", "ScrewHead")),
              HasSubstr("Action7 does not change what ScrewHead changes"));
  EXPECT_THAT(Apply(Edits().Merge("Action7", "Action7")),
              HasSubstr("is the same action"));
  EXPECT_THAT(Apply(Edits().Merge("Action7", "Present")),
              HasSubstr("nothing has been learned of Present"));
  EXPECT_EQ(Apply(Edits().Merge("Action7", "PlaceRoundPeg")), "");
  EXPECT_TRUE(Of("Action7").is_removed());
  const auto merged =
      ReadActionModel(Of("PlaceRoundPeg"), task_.domain, task_.parts);
  EXPECT_EQ(merged.sec->NumShown(), 12) << "6 showings twice";
}

TEST_F(RecordEditsTest, TakesADemonstrationBackFromAllThatItTaught) {
  EXPECT_THAT(Apply(Edits().TakeBack("assembly 7")),
              HasSubstr("'assembly 7' has taught nothing"));
  EXPECT_EQ(Apply(Edits().TakeBack("assembly 2")), "");
  EXPECT_THAT(Of("PlaceRoundPeg").sec, HasSubstr("assembly 1: 3"));
  EXPECT_THAT(Of("PlaceRoundPeg").sec, Not(HasSubstr("assembly 2")));
  EXPECT_EQ(Of("Raise").version, 1) << "other demonstrations taught it";
  EXPECT_EQ(Apply(Edits().TakeBack("assembly 1")), "");
  EXPECT_EQ(Of("PlaceRoundPeg").sec, "") << "it is not recognised any more";
  EXPECT_NE(Of("PlaceRoundPeg").rules, "") << "but an arm still does it";
}

TEST_F(RecordEditsTest, ARollBackRestoresWhateverWasDone) {
  store_.BeginRun();
  const LibraryContent content = store_.Content();
  const RecordEdits::Records& start = content.actions;
  EXPECT_EQ(Apply(Edits().Rename("ScrewHead", "Screw")), "");
  EXPECT_EQ(Apply(Edits().TakeBack("assembly 2")), "");
  EXPECT_EQ(Apply(Edits().Remove("RemoveFacePlate")), "");
  EXPECT_EQ(Apply(Edits().Remove("PlaceFacePlate")), "");
  EXPECT_EQ(Apply(Edits().Restore(content)), "");
  for (ActionRecord record : store_.All()) {
    const auto was = std::ranges::find(start, record.name, &ActionRecord::name);
    if (was == start.end()) {
      EXPECT_TRUE(record.is_removed()) << record.name;
      continue;
    }
    record.id = was->id;
    record.version = was->version;
    EXPECT_EQ(record, *was) << record.name;
  }
  EXPECT_THAT(Apply(Edits().Restore(content)), HasSubstr("already holds that"));
}

/// Whichever record or experience a disk fails at, an edit is made as a whole
/// or not at all.
TEST_F(RecordEditsTest, AnEditThatIsInterruptedLeavesTheLibraryAsItWas) {
  const fs::path dir = NewTestFolder();
  for (int failing = 0; failing < 6; ++failing) {
    const fs::path file = dir / (std::to_string(failing) + ".db");
    {
      SqliteActionStore store(file, SqliteActionStore::Mode::kCreate);
      store.Store(store_.All(), kBeforeRun);
      for (int i = 0; i < 2; ++i) {
        store.Keep(Tried("PlaceSeparator", i), kBeforeRun);
      }
    }
    {
      SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
      const auto fail_at = [&](const std::string& table, int id) {
        database.exec("CREATE TRIGGER fail_" + table + " BEFORE INSERT ON " +
                      table + " WHEN NEW.id = " + std::to_string(id) +
                      " BEGIN SELECT RAISE(ABORT, 'no more'); END");
      };
      fail_at("action", 16 + failing);
      fail_at("experience", failing);  // 3, 4: they move; 5: none does
    }
    SqliteActionStore store(file, SqliteActionStore::Mode::kExisting);
    const LibraryContent before = store.Content();
    const auto edit = RecordEdits(before, task_.domain, task_.parts)
                          .Rename("PlaceSeparator", "Divide");
    ASSERT_TRUE(edit) << edit.reason();
    ASSERT_EQ(edit->records.size(), 3u);
    ASSERT_EQ(edit->experiences.size(), 2u);
    if (failing < 5) {
      EXPECT_THROW(store.Apply(*edit, kBeforeRun), StoreError) << failing;
      EXPECT_EQ(store.All(), before.actions) << failing;
      EXPECT_EQ(store.Content().experiences, before.experiences) << failing;
    } else {
      store.Apply(*edit, kBeforeRun);
      EXPECT_FALSE(store.FindNamed("Divide")->is_removed());
      EXPECT_THAT(ExperiencesOf(store), ElementsAre("3 Divide", "4 Divide"));
    }
  }
  fs::remove_all(dir);
}

}  // namespace
}  // namespace cell
