// The similarity matrix of what taught a library, its histogram and bounds.
#include "common/sec/library_members.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/unit/sec/shown_library.h"

namespace cell {
namespace {

using testing::IsEmpty;

class LibraryMembersTest : public ShownLibrary {
 protected:
  LibraryMembers Compare() const {
    return CompareMembers(models_, words_, *chains_);
  }
  size_t NumberOf(const std::string& name) const {
    return static_cast<size_t>(
        std::distance(models_.begin(), models_.find(name)));
  }
};

TEST_F(LibraryMembersTest, AreAllContributionsInTheOrderOfTheModels) {
  const LibraryMembers members = Compare();
  size_t next = 0, number = 0;
  for (const auto& [name, model] : models_) {
    EXPECT_EQ(members.OfModel(number).size(), model.taught.size()) << name;
    for (size_t k = 0; k < model.taught.size(); ++k) {
      EXPECT_EQ(members.model_of.at(next++), number) << name;
    }
    ++number;
  }
  EXPECT_EQ(members.names.size(), next);
}

TEST_F(LibraryMembersTest, AreAsSimilarToEachOtherAsTheirModelsAlone) {
  const LibraryMembers all = Compare();
  for (const auto& [name, model] : models_) {
    const LibraryMembers alone =
        CompareMembers({{name, model}}, words_, *chains_);
    EXPECT_EQ(all.OfModel(NumberOf(name)), alone.similarities) << name;
  }
}

TEST_F(LibraryMembersTest, TheHistogramCountsEachPairOnce) {
  const LibraryMembers members = Compare();
  const MemberHistogram histogram = HistogramOf(members);
  const size_t num = members.names.size();
  ASSERT_GT(num, 1u);
  EXPECT_EQ(histogram.num_pairs(), num * (num - 1) / 2);
  size_t num_of_one = 0;
  for (const auto& [name, model] : models_) {
    num_of_one += model.taught.size() * (model.taught.size() - 1) / 2;
  }
  size_t counted = 0;
  for (const size_t in_bin : histogram.of_one) counted += in_bin;
  EXPECT_EQ(counted, num_of_one);
}

TEST_F(LibraryMembersTest, OtsusBoundDividesAllButWhatOnlyTypesTellApart) {
  const LibraryMembers members = Compare();
  const MemberHistogram histogram = HistogramOf(members);
  EXPECT_GE(histogram.tau, histogram.cut);
  for (size_t i = 0; i < members.names.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      if (members.model_of[i] != members.model_of[j]) continue;
      EXPECT_GE(members.similarities[i][j], histogram.cut);
    }
  }
  using Pairs = std::vector<std::pair<size_t, size_t>>;
  EXPECT_EQ(histogram.alike,
            (Pairs{{NumberOf("PlaceRoundPeg"), NumberOf("PlaceSquarePeg")}}));
}

TEST_F(LibraryMembersTest, ALibraryOfOneShowingHasNoPairs) {
  const auto first = models_.begin();
  LearnedModel model = first->second;
  model.taught.resize(1);
  const MemberHistogram histogram =
      HistogramOf(CompareMembers({{first->first, model}}, words_, *chains_));
  EXPECT_EQ(histogram.num_pairs(), 0u);
  EXPECT_THAT(histogram.alike, IsEmpty());
}

}  // namespace
}  // namespace cell
