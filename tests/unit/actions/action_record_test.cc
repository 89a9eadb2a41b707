// Records of actions: what may be kept, and how they are written down.
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <random>

#include "common/actions/action_model_reader.h"
#include "common/actions/action_model_writer.h"
#include "common/actions/action_models.h"
#include "common/actions/record_messages.h"
#include "services/library/content_json.h"
#include "services/library/memory_action_store.h"
#include "services/library/record_check.h"
#include "services/library/record_json.h"
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
        Sec("pick: {where: [\"PegInHole(X, Y)\"]}\n"
            "place: {where: [\"not PegInHole(X, Y)\"], touch: [table]}\n");
    return record;
  }
  static std::string Sec(const std::string& facts) {
    return "roles: {X: square_peg, Y: square_hole}\nmoved: X\n" + facts +
           "chain: {table: 01}\nshown: {take_backs 3: 1}";
  }
  std::string ReasonFor(
      const std::function<void(ActionRecord&)>& change) const {
    ActionRecord record = New();
    change(record);
    const auto refusal = check_.WhyNot(record, known_);
    return refusal ? refusal->reason : "";
  }

  const ShippedTask task_;
  const std::vector<ActionRecord> of_task_ =
      WriteActionModels(task_.actions, task_.domain);
  const MemoryActionStore known_{of_task_};
  const RecordCheck check_ = RecordCheck::FromTask(ShippedDeployment());
};

TEST_F(Records, AreReadAsTheModelsThatWereWritten) {
  ASSERT_EQ(of_task_.size(), task_.domain.actions().size());
  for (size_t i = 0; i < of_task_.size(); ++i) {
    const ActionModel read =
        ReadActionModel(of_task_[i], task_.domain, task_.parts);
    EXPECT_EQ(read, task_.actions[i]) << of_task_[i].rules;
    EXPECT_EQ(WriteActionModel(read, task_.domain), of_task_[i]);
    EXPECT_EQ(ReadAction(of_task_[i], task_.domain), task_.domain.actions()[i]);
  }
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
                HasSubstr("its name should be a letter"));
  }
  EXPECT_THAT(ReasonFor([](auto& r) { r.arguments[0].type = "cup"; }),
              HasSubstr("LayAside:arguments.X: there is no type 'cup'"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.arguments[1].name = "X"; }),
              HasSubstr("two are named 'X'"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.agents = {"cat"}; }),
              HasSubstr("'cat' is neither person nor robot"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.agents = {}; }),
              HasSubstr("names no agent"));
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
  EXPECT_THAT(ReasonFor([](auto& r) {
                r.sec.replace(r.sec.find("square_peg"), 10, "peg");
              }),
              HasSubstr("LayAside:sec.roles: should be the arguments of "
                        "LayAside, or narrower: X: square_peg, "));
  EXPECT_THAT(ReasonFor([](auto& r) { r.sec += "\n[a]: red"; }),
              HasSubstr("LayAside:sec: a map or a list cannot be a key"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.skill_settings = "insertion"; }),
              HasSubstr("is required with a skill"));
  EXPECT_THAT(ReasonFor([](auto& r) {
                r.agents = {"robot"};
                r.skill = "{name: put_down, part: X, arm: left}";
                r.skill_settings = "juggling";
              }),
              HasSubstr("skills.yaml has no section 'juggling'"));
}

TEST_F(Records, OfAnotherDomainOrWithoutVariablesSayWhatWouldBeRight) {
  EXPECT_THAT(ReasonFor([](auto& r) {
                r.rules = "- {context: [DoorOpen(X)], outcomes: [], noise: 1}";
              }),
              HasSubstr("LayAside:rules[0].context[0]"));
  EXPECT_THAT(ReasonFor([](auto& r) {
                r.sec =
                    Sec("pick: {where: [HeadScrewed(head)]}\n"
                        "place: {where: [\"PegInHole(X, Y)\"]}\n");
              }),
              HasSubstr("LayAside:sec: nothing that pick says is changed"));
  EXPECT_THAT(ReasonFor([](auto& r) {
                r.sec =
                    Sec("pick: {where: [Horizontal(X)]}\n"
                        "place: {where: [not Horizontal(X)]}\n");
              }),
              HasSubstr("neither pick nor place mentions Y"));
  EXPECT_THAT(ReasonFor([](auto& r) {
                r.rules =
                    "- {agents: [robot], context: [], outcomes: [], "
                    "noise: 1}";
              }),
              HasSubstr("LayAside:rules[0].agents: not all of them"));
}

TEST_F(Records, ReplaceTheLastOfTheirNameByTheNextVersion) {
  ActionRecord record = *known_.FindNamed("RemoveHead");
  record.id = 0;
  record.version = 2;
  EXPECT_FALSE(check_.WhyNot(record, known_));
  record.version = 3;
  EXPECT_THAT(check_.WhyNot(record, known_)->reason,
              HasSubstr("has the version 3; the next of 'RemoveHead' is 2"));
  record.version = 2;
  record.arguments[0].type = "peg";
  record.rules = "- {context: [], outcomes: [], noise: 1}";
  EXPECT_THAT(check_.WhyNot(record, known_)->reason,
              HasSubstr("a new version must keep those of the last: head"));
  EXPECT_THAT(ReasonFor([](auto& r) { r.version = 2; }),
              HasSubstr("the next of 'LayAside' is 1"));
  for (const int64_t version : {std::numeric_limits<int64_t>::max(),
                                std::numeric_limits<int64_t>::min()}) {
    EXPECT_THAT(ReasonFor([&](auto& r) { r.version = version; }),
                HasSubstr("1 to 1000000000 are allowed"));
  }
}

TEST_F(Records, OfAnotherTaskInAStoreAreNamed) {
  EXPECT_EQ(check_.WhyOfAnotherTask(known_), std::nullopt);
  ActionRecord record = New();
  record.arguments[0].type = "cabin_door";
  MemoryActionStore store{{&record, 1}};
  EXPECT_THAT(check_.WhyOfAnotherTask(store).value(),
              HasSubstr("action 1: LayAside:arguments.X"));
}

TEST_F(Records, ReplaceTheModelsThatAreKnown) {
  ActionModels models(task_.domain, task_.parts, task_.actions);
  for (const ActionRecord& record : of_task_) {
    const auto same = models.Apply(record);
    ASSERT_TRUE(same) << same.reason();
    EXPECT_EQ(*same, ActionModels::Update::kNone) << record.name;
  }
  ActionRecord changed = *known_.FindNamed("RemoveHead");
  changed.version = 2;
  changed.rules =
      "- {context: [HeadScrewed(X)], outcomes: [{probability: 0.5, effects: "
      "[not HeadScrewed(X)]}], noise: 0.5}";
  EXPECT_EQ(*models.Apply(changed), ActionModels::Update::kChanged);
  EXPECT_EQ(*models.Apply(changed), ActionModels::Update::kNone);
  const int place = *models.domain().FindAction("RemoveHead");
  EXPECT_EQ(models.domain().actions()[place].rules[0].noise, 0.5);
  EXPECT_EQ(models.models()[place].version, 2);
  EXPECT_EQ(models.models().size(), task_.actions.size());

  EXPECT_EQ(*models.Apply(New()), ActionModels::Update::kChanged);
  EXPECT_EQ(models.models().back().action.name, "LayAside");
  changed.rules = "- nonsense";
  const auto refused = models.Apply(changed);
  EXPECT_FALSE(refused);
  EXPECT_THAT(refused.reason(), HasSubstr("RemoveHead:rules[0]"));
  EXPECT_EQ(models.models()[place].version, 2);
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
  EXPECT_EQ(
      ContentFromText(TextOfContent({.actions = records}), "a.json").actions,
      records);
}

TEST_F(Records, OfTheFirstFormatHaveTheFirstVersion) {
  std::string text = TextOfContent({.actions = {of_task_[0]}});
  const std::string of_record = "\"version\": 1,";
  text.erase(text.find(of_record), of_record.size());
  text.replace(text.find("\"version\": 4"), 12, "\"version\": 1");
  text.resize(text.find(",\n \"last_experience\""));
  text += "}";
  EXPECT_EQ(ContentFromText(text, "a.json").actions, std::vector{of_task_[0]});
}

TEST_F(Records, AreReadStrictlyFromJson) {
  const std::string good = TextOfContent({.actions = {of_task_[0]}});
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
  EXPECT_THAT(complaint("{", ""), HasSubstr("a.json:2: is not JSON"));
  EXPECT_THAT(complaint("\"version\": 4", "\"version\": 5"),
              testing::AllOf(HasSubstr("a.json.version: is 5; this build ("),
                             HasSubstr("reads 1 to 4; use build ")));
  EXPECT_THAT(complaint("\"build\"", "\"built\""),
              HasSubstr("a.json.built: not known"));
  EXPECT_THAT(complaint("actions of a cell", "recipes"),
              HasSubstr("a.json.format: should be"));
  EXPECT_THAT(complaint("\"id\": 0", "\"id\": 0.5"),
              HasSubstr("a.json:actions[0].id: should be a whole number"));
  EXPECT_THAT(complaint("\"version\": 1,", "\"version\": 9223372036854775807,"),
              HasSubstr("a.json:actions[0].version: is not 1 to 1000000000"));
  EXPECT_THAT(complaint("\"version\": 1,", "\"version\": 0,"),
              HasSubstr("a.json:actions[0].version: is not 1 to 1000000000"));
  EXPECT_THAT(complaint("\"undoes\"", "\"undos\""),
              HasSubstr("a.json:actions[0].undos: not known"));
  EXPECT_THAT(complaint("\"undoes\": \"\",", ""),
              HasSubstr("a.json:actions[0].undoes: missing"));
  EXPECT_THAT(complaint("\"type\": \"", "\"type\": 3, \"x\": \""),
              HasSubstr("a.json:actions[0].arguments[0]"));
}

}  // namespace
}  // namespace cell
