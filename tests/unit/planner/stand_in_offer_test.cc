// A question about a missing part names what could be used instead.
#include "services/planner/stand_in_offer.h"

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/actions/action_model_writer.h"
#include "services/planner/knowledge.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace planner;

namespace {

/// Only the shaft was ever shown to be put into a round hole, and it is missing
/// for base.round_1.
class StandInOffer : public testing::Test {
 protected:
  StandInOffer() : rules_(RuleSet::FromDomain(task_.domain)) {
    for (const ActionModel& model : task_.actions) {
      if (model.sec) models_.emplace(model.action.name, *model.sec);
    }
    models_.at("PlaceRoundPeg").roles[0].type =
        *vocabulary().types().Find("shaft");
    Set("Clear(round_peg_1)", Truth::kTrue);
    Set("Clear(round_peg_2)", Truth::kTrue);
    question_.needed = {Change("Clear(shaft)", Truth::kTrue),
                        Change("Reachable(right, shaft)", Truth::kTrue)};
  }

  const Vocabulary& vocabulary() const { return rules_->vocabulary(); }
  int Atom(const std::string& name) const {
    for (int i = 0; i < vocabulary().num_atoms(); ++i) {
      if (vocabulary().AtomName(i) == name) return i;
    }
    ADD_FAILURE() << "no atom " << name;
    return 0;
  }
  void Set(const std::string& atom, Truth truth) {
    state_.Set(Atom(atom), truth);
  }
  GroundAction Placing(const std::string& part) const {
    GroundAction action =
        rules_->FindGroundAction("PlaceRoundPeg", {"shaft", "base.round_1"})
            .value();
    action.arguments[0] = vocabulary().FindObject(part).value();
    return action;
  }
  RequiredChange Change(const std::string& atom, Truth truth) const {
    return {Atom(atom), truth, "", Placing("shaft")};
  }
  void Offer() { OfferStandIns(models_, *rules_, state_, &question_); }

  const ShippedTask task_;
  const std::shared_ptr<const RuleSet> rules_;
  SecModels models_;
  State state_{vocabulary().num_atoms()};
  ExecutionStatus question_{.state = ExecutionStatus::State::kStuck,
                            .text = "where is it?"};
};

TEST_F(StandInOffer, NamesWhatFitsThereAndAsksForItsPlacement) {
  Offer();
  EXPECT_EQ(question_.text,
            "where is it?; round_peg_1 or round_peg_2 could stand in for "
            "shaft");
  EXPECT_EQ(question_.step, Placing("round_peg_1"));
}

TEST_F(StandInOffer, LeavesOutWhatIsMissingItself) {
  Set("Clear(round_peg_1)", Truth::kFalse);
  Offer();
  EXPECT_EQ(question_.text,
            "where is it?; round_peg_2 could stand in for shaft");
  EXPECT_EQ(question_.step, Placing("round_peg_2"));
}

TEST_F(StandInOffer, DoesNotReplaceWhatElseIsAskedFor) {
  question_.needed.push_back(Change("Free(base.round_1)", Truth::kTrue));
  Offer();
  EXPECT_THAT(question_.text, testing::HasSubstr("round_peg_1"));
  EXPECT_EQ(question_.step, std::nullopt);
}

TEST_F(StandInOffer, IsNothingIfNoPartIsMissing) {
  question_.needed = {Change("Free(base.round_1)", Truth::kTrue)};
  const ExecutionStatus before = question_;
  Offer();
  EXPECT_EQ(question_, before);
}

TEST_F(StandInOffer, IsNothingForAnActionThatWasNeverShown) {
  models_.erase("PlaceRoundPeg");
  const ExecutionStatus before = question_;
  Offer();
  EXPECT_EQ(question_, before);
}

TEST_F(StandInOffer, FollowsTheRecordsOfTheLibrary) {
  Knowledge knowledge(task_.domain, false);
  EXPECT_EQ(knowledge.sec_models(), nullptr);
  knowledge.SetModels(ActionModels(task_.domain, task_.parts, task_.actions));
  ASSERT_TRUE(knowledge.sec_models()->contains("PlaceRoundPeg"));
  auto records = WriteActionModels(task_.actions, task_.domain);
  for (ActionRecord& record : records) {
    if (record.name == "PlaceRoundPeg") record.sec.clear();
    knowledge.Put(record);
  }
  EXPECT_FALSE(knowledge.sec_models()->contains("PlaceRoundPeg"));
  EXPECT_TRUE(knowledge.sec_models()->contains("PlaceSquarePeg"));
}

}  // namespace
}  // namespace cell
