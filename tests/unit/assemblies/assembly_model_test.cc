#include "common/assemblies/assembly_model.h"

#include <gmock/gmock.h>

#include "common/rules/rule_text.h"
#include "tests/unit/assemblies/small_assemblies.h"

namespace cell::assemblies {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const PartPair kSeat = MakePair("seat", "frame");
const PartPair kRoof = MakePair("roof", "frame");
const PartPair kLamp = MakePair("lamp", "frame");

/// Two who learn that the seat comes before the roof, and a lamp any time.
std::vector<AssemblySequence> SeatBeforeRoof() {
  return {
      MakeSequence({"attach,lamp,frame,correct,",
                    "attach,roof,frame,mistake,wrong order",
                    "detach,roof,frame,correction,",
                    "attach,seat,frame,correct,",
                    "attach,roof,frame,correct,"}),
      MakeSequence({"attach,seat,frame,correct,", "attach,roof,frame,correct,",
                    "attach,lamp,frame,correct,"})};
}

std::vector<PartPair> PreconditionsOf(const AssemblyModel& model,
                                      const PartPair& pair) {
  std::vector<PartPair> required;
  const auto index = static_cast<size_t>(model.rule_of.at(pair));
  for (const rules::Literal& literal : model.rules.rules[index].context) {
    required.push_back(PairOf(literal, model.rules));
  }
  return required;
}

TEST(AssemblyModel, RequiresWhatWasMissingInAWrongOrderAndNothingElse) {
  const AssemblyModel model =
      LearnModel(EvidenceFrom(SeatBeforeRoof()), {}, {});
  EXPECT_THAT(model.goal, UnorderedElementsAre(kSeat, kRoof, kLamp));
  EXPECT_THAT(PreconditionsOf(model, kRoof), UnorderedElementsAre(kSeat));
  EXPECT_THAT(PreconditionsOf(model, kSeat), IsEmpty());
  EXPECT_THAT(PreconditionsOf(model, kLamp), IsEmpty());
}

TEST(AssemblyModel, AnOrderThatWasNeverWrongIsNoPrecondition) {
  const AssemblyModel model =
      LearnModel(EvidenceFrom({SeatBeforeRoof()[1]}), {}, {});
  EXPECT_THAT(PreconditionsOf(model, kRoof), IsEmpty());
}

TEST(AssemblyModel, OtherToysTeachPartsOfTheSameNames) {
  OrderPrior prior;
  const OrderEvidence other = EvidenceFrom(SeatBeforeRoof());
  prior.Add(other);
  const OrderEvidence own = EvidenceFrom({SeatBeforeRoof()[1]});
  EXPECT_THAT(PreconditionsOf(LearnModel(own, prior, {}), kRoof),
              UnorderedElementsAre(kSeat));
  prior.Remove(other);
  EXPECT_THAT(PreconditionsOf(LearnModel(own, prior, {}), kRoof), IsEmpty());
}

TEST(AssemblyModel, OneCorrectAssemblyWithoutItRefutesAPrecondition) {
  auto sequences = SeatBeforeRoof();
  sequences.push_back(MakeSequence(
      {"attach,roof,frame,correct,", "attach,seat,frame,correct,"}));
  const AssemblyModel model = LearnModel(EvidenceFrom(sequences), {}, {});
  EXPECT_THAT(PreconditionsOf(model, kRoof), IsEmpty());
}

TEST(AssemblyModel, PreconditionsAreNeverACycle) {
  // Each was called wrong without the other, and never stayed.
  const AssemblyModel model = LearnModel(
      EvidenceFrom({MakeSequence(
          {"attach,seat,frame,mistake,wrong order",
           "attach,seat,frame,correct,", "detach,seat,frame,correction,",
           "attach,roof,frame,mistake,wrong order",
           "attach,roof,frame,correct,", "detach,roof,frame,correction,"})}),
      {}, {});
  const size_t num_preconditions = PreconditionsOf(model, kRoof).size() +
                                   PreconditionsOf(model, kSeat).size();
  EXPECT_EQ(num_preconditions, 1u);
}

TEST(AssemblyModel, ItsRulesAreWrittenAndReadBack) {
  const AssemblyModel model =
      LearnModel(EvidenceFrom(SeatBeforeRoof()), {}, {});
  const std::string text = rules::ToText(model.rules);
  EXPECT_THAT(text, HasSubstr("Action: attach_frame__roof()\n"
                              "Preconditions: joined(frame, seat)\n"));
  const rules::NdrRules again = rules::ParseRules(text, "r");
  EXPECT_EQ(again.rules, model.rules.rules);
  EXPECT_EQ(*again.symbols, *model.rules.symbols);
}

}  // namespace
}  // namespace cell::assemblies
