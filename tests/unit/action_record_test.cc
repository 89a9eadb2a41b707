// Records of actions: what may be kept, and how they are written down.
#include <gmock/gmock.h>

#include <functional>
#include <random>

#include "common/sec/gallery.h"
#include "services/library/memory_action_store.h"
#include "services/library/record_check.h"
#include "services/library/record_json.h"
#include "services/library/record_language.h"
#include "services/library/record_messages.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace library;
namespace {

using testing::HasSubstr;

class Records : public testing::Test {
 protected:
  /// Takes a peg out of the square hole and lays it on the table: a new one.
  ActionRecord New() const {
    ActionRecord record = *known_.FindNamed("RemoveSquarePeg");
    record.id = 0;
    record.name = "LayAside";
    record.undoes = "";
    record.sec =
        "moved: X\npick: {where: [\"PegInHole(X, Y)\"]}\n"
        "place: {where: [\"not PegInHole(X, Y)\"], touch: [[X, table]]}";
    return record;
  }
  std::string ReasonFor(
      const std::function<void(ActionRecord&)>& change) const {
    ActionRecord record = New();
    change(record);
    const auto refusal = check_.WhyNot(record, known_);
    return refusal ? refusal->reason : "";
  }

  const ShippedTask task_;
  const std::vector<ActionRecord> of_task_ = TaskActions(task_.domain_config);
  const MemoryActionStore known_{of_task_};
  const RecordCheck check_ = RecordCheck::FromTask(ShippedDeployment());
};

TEST_F(Records, OfTheTaskSayWhatItsDomainSays) {
  ASSERT_EQ(of_task_.size(), task_.domain.actions().size());
  const Gallery gallery(task_.domain, task_.parts);
  size_t num_recognised = 0;
  for (size_t i = 0; i < of_task_.size(); ++i) {
    const Config config = ConfigOf(of_task_[i]);
    const Action read =
        LoadAction(of_task_[i].name, config, task_.domain.vocabulary());
    const Action& written = task_.domain.actions()[i];
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.arguments, written.arguments);
    EXPECT_EQ(read.agents, written.agents);
    EXPECT_EQ(read.rules, written.rules) << read.name;
    EXPECT_EQ(read.skill, written.skill) << read.name;
    ASSERT_EQ(read.sec.has_value(), written.sec.has_value()) << read.name;
    if (read.sec) {
      const GalleryEntry entry = gallery.Read(read, static_cast<int>(i));
      const GalleryEntry& shipped = gallery.entries()[num_recognised++];
      EXPECT_EQ(entry.moved, shipped.moved);
      EXPECT_EQ(entry.pick.where, shipped.pick.where) << read.name;
      EXPECT_EQ(entry.place.where, shipped.place.where) << read.name;
      EXPECT_EQ(entry.pick.touch, shipped.pick.touch) << read.name;
    }
    config.Finish();
  }
  EXPECT_EQ(num_recognised, gallery.entries().size());
}

TEST_F(Records, OfTheTaskMayBeKeptOneAfterTheOther) {
  MemoryActionStore store;
  for (const ActionRecord& record : of_task_) {
    const auto refusal = check_.WhyNot(record, store);
    EXPECT_FALSE(refusal) << refusal->reason;
    store.Store({&record, 1}, 0);
  }
}

TEST_F(Records, AreRefusedForAReason) {
  EXPECT_EQ(ReasonFor([](auto&) {}), "");
  EXPECT_THAT(ReasonFor([](auto& r) { r.id = 3; }), HasSubstr("has the id 3"));
  EXPECT_EQ(ReasonFor([](auto& r) { r.name = ""; }), "its name is empty");
  for (const std::string& name :
       std::vector<std::string>{"two words", "9", "_", std::string(65, 'a')}) {
    EXPECT_THAT(ReasonFor([&](auto& r) { r.name = name; }),
                HasSubstr("its name is not a letter"));
  }
  EXPECT_THAT(ReasonFor([](auto& r) { r.arguments[0].type = "cup"; }),
              HasSubstr("LayAside:arguments.X: there is no type 'cup'"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.arguments[1].name = "X"; }),
              HasSubstr("two are named 'X'"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.agents = {"cat"}; }),
              HasSubstr("'cat' is neither person nor robot"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.agents = {}; }),
              HasSubstr("nobody can do it"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.undoes = "Fly"; }),
              HasSubstr("there is no action 'Fly'"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.undoes = "Raise"; }),
              HasSubstr("'Raise' takes other arguments"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.rules = ""; }), HasSubstr("missing"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.rules = "- context: [On(X)]"; }),
              HasSubstr("LayAside:rules[0].context[0]"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.rules += "\n---\na: 1"; }),
              HasSubstr("LayAside:rules: not "));
  EXPECT_THAT(ReasonFor([](auto& r) { r.rules += "\n]\n"; }),
              HasSubstr("LayAside:rules: not "));
  EXPECT_THAT(ReasonFor([](auto& r) { r.rules = "[&a [], *a]"; }),
              HasSubstr("anchors and aliases"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.rules = std::string(9000, '['); }),
              HasSubstr("not YAML"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.rules = "\xff"; }),
              HasSubstr("is not UTF-8"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.sec += "\ncolour: red"; }),
              HasSubstr("LayAside:sec.colour: not known"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.sec += "\n[a]: red"; }),
              HasSubstr("LayAside:sec: a map or a list cannot be a key"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.skill_settings = "insertion"; }),
              HasSubstr("goes with a skill"));
  EXPECT_THAT(ReasonFor([](auto& r) {
                r.agents = {"robot"};
                r.skill = "{kind: put_down, part: X, arm: left}";
                r.skill_settings = "juggling";
              }),
              HasSubstr("skills.yaml has no section 'juggling'"));
}

TEST_F(Records, ThatAreThereOrTooLargeAreRefusedAsSuch) {
  ActionRecord record = New();
  record.name = "RemoveHead";
  const auto duplicate = check_.WhyNot(record, known_);
  ASSERT_TRUE(duplicate);
  EXPECT_EQ(duplicate->kind, Refusal::Kind::kDuplicate);
  EXPECT_EQ(duplicate->known_id, known_.FindNamed("RemoveHead")->id);
  record.rules.resize(RecordCheck::kMaxBytes, ' ');
  const auto too_large = check_.WhyNot(record, known_);
  ASSERT_TRUE(too_large);
  EXPECT_EQ(too_large->kind, Refusal::Kind::kTooLarge);
}

TEST_F(Records, WithBytesChangedByChanceNeverThrow) {
  std::mt19937 random(4);
  int num_refused = 0;
  constexpr int kNum = 3000;
  for (int i = 0; i < kNum; ++i) {
    ActionRecord record = of_task_[random() % of_task_.size()];
    record.name = "Fresh";
    for (std::string* text :
         {&record.sec, &record.rules, &record.robot, &record.skill}) {
      for (auto n = random() % 3; n > 0 && !text->empty(); --n) {
        (*text)[random() % text->size()] = static_cast<char>(random() % 128);
      }
    }
    num_refused += check_.WhyNot(record, known_).has_value();
  }
  EXPECT_GT(num_refused, kNum / 2);
  EXPECT_LT(num_refused, kNum);
}

TEST_F(Records, AreTheSameAfterTheirMessageAndTheirJson) {
  std::vector<ActionRecord> records = of_task_;
  for (size_t i = 0; i < records.size(); ++i) {
    records[i].id = static_cast<int64_t>(i) + 1;
    EXPECT_EQ(FromMessage(ToMessage(records[i])), records[i]);
  }
  EXPECT_EQ(ContentFromText(TextOfContent(records), "a.json"), records);
}

TEST_F(Records, AreReadStrictlyFromJson) {
  const std::string good = TextOfContent({of_task_[0]});
  const auto complaint = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    try {
      ContentFromText(text.replace(at, from.size(), to), "a.json");
      return std::string();
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
  };
  EXPECT_EQ(complaint("\"id\"", "\"id\""), "");
  EXPECT_THAT(complaint("{", ""), HasSubstr("a.json: is not JSON"));
  EXPECT_THAT(complaint("\"version\": 1", "\"version\": 2"),
              HasSubstr("a.json.version: is not 1"));
  EXPECT_THAT(complaint("actions of a cell", "recipes"),
              HasSubstr("a.json.format: should be"));
  EXPECT_THAT(complaint("\"id\": 0", "\"id\": 0.5"),
              HasSubstr("a.json:actions[0].id: should be a whole number"));
  EXPECT_THAT(complaint("\"undoes\"", "\"undos\""),
              HasSubstr("a.json:actions[0].undos: not known"));
  EXPECT_THAT(complaint("\"undoes\": \"\",", ""),
              HasSubstr("a.json:actions[0].undoes: missing"));
  EXPECT_THAT(complaint("\"type\": \"", "\"type\": 3, \"x\": \""),
              HasSubstr("a.json:actions[0].arguments[0]"));
}

}  // namespace
}  // namespace cell
