// What could be used where the usual part of an action is missing.
#include "common/sec/stand_in_proposal.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Only the shaft was ever shown to be put into a round hole.
class StandInProposal : public testing::Test {
 protected:
  StandInProposal() {
    for (const ActionModel& model : task_.actions) {
      if (!model.sec) continue;
      all_.push_back(*model.sec);
      if (model.action.name == "PlaceRoundPeg") place_ = all_.size() - 1;
    }
    all_[place_].roles[0].type = *vocabulary().types().Find("shaft");
  }
  const Vocabulary& vocabulary() const { return task_.domain.vocabulary(); }
  int Object(const std::string& name) const {
    return vocabulary().FindObject(name).value();
  }
  std::vector<std::string> ProposedFor(const std::string& hole) const {
    std::vector<std::string> names;
    for (const int object :
         ProposeStandIns(all_[place_], all_, {Object("shaft"), Object(hole)},
                         state_, vocabulary())) {
      names.push_back(vocabulary().objects()[object].name);
    }
    return names;
  }
  void MakeTrue(const std::string& atom) {
    for (int i = 0; i < state_.num_atoms(); ++i) {
      if (vocabulary().AtomName(i) == atom) state_.Set(i, Truth::kTrue);
    }
  }

  const ShippedTask task_;
  std::vector<LearnedModel> all_;
  size_t place_ = 0;
  State state_{vocabulary().num_atoms()};
};

TEST_F(StandInProposal, IsWhatFitsThere) {
  EXPECT_THAT(ProposedFor("base.round_1"),
              ElementsAre("round_peg_1", "round_peg_2"));
  EXPECT_THAT(ProposedFor("base.shaft"), IsEmpty());
}

TEST_F(StandInProposal, IsNotWhatIsInUse) {
  MakeTrue("PegInHole(round_peg_1, base.round_2)");
  EXPECT_THAT(ProposedFor("base.round_1"), ElementsAre("round_peg_2"));
}

TEST_F(StandInProposal, IsNothingThatHasAnActionOfItsOwn) {
  all_[place_].roles[0].type = *vocabulary().types().Find("cylindrical_peg");
  EXPECT_THAT(ProposedFor("base.round_1"), IsEmpty());
}

}  // namespace
}  // namespace cell
