#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "services/cell/evaluations/sec_classes.h"
#include "services/cell/evaluations/sec_figures.h"
#include "services/cell/evaluations/sec_groups.h"
#include "services/cell/evaluations/sec_recordings.h"
#include "services/cell/evaluations/sec_statements.h"
#include "tests/test_folder.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;

constexpr auto kSilent = [](const std::string&) {
};

// A curve that falls in straight lines from 100 to `middle` at p = 0.5 and
// `end` at p = 1.
SecCurve Curve(const std::string& seed, bool has_flips, double middle,
               double end) {
  SecCurve curve{"paper", seed, has_flips, {}};
  for (size_t level = 0; level < kNumNoiseLevels; ++level) {
    const auto x = static_cast<double>(level);
    curve.points[level].mean =
        (level <= 5 ? 100 - (100 - middle) * x / 5
                    : middle - (middle - end) * (x - 5) / 5) /
        100;
  }
  return curve;
}

std::vector<bool> Verdicts(const std::vector<SecStatement>& statements) {
  std::vector<bool> verdicts;
  for (const auto& statement : statements) {
    verdicts.push_back(statement.is_true);
  }
  return verdicts;
}

TEST(SecStatements, OnFigure13AreTrueForCurvesAsTheTextSays) {
  auto red = Curve("Fig. 12", true, 34, 28);
  red.points[2].mean = 0.70;
  red.points[3].mean = 0.55;
  const auto blue = Curve("Fig. 12", false, 82, 62);
  EXPECT_THAT(Verdicts(CheckStatements("13", "paper", {red, blue})),
              testing::Each(true));
}

TEST(SecStatements, OnFigure13AreFalseWhereCurvesDiffer) {
  const auto red = Curve("Fig. 12", true, 50, 0);     // one slope, ends low
  const auto blue = Curve("Fig. 12", false, 45, 40);  // crosses red
  const auto verdicts = Verdicts(CheckStatements("13", "paper", {red, blue}));
  EXPECT_EQ(verdicts, (std::vector<bool>{true, false, false, false, false,
                                         false, false}));
}

TEST(SecStatements, OnFigure15ReadAllSeeds) {
  const std::vector<SecCurve> alike = {
      Curve("I", true, 20, 15), Curve("II", true, 18, 15),
      Curve("I", false, 70, 60), Curve("II", false, 68, 60)};
  EXPECT_THAT(Verdicts(CheckStatements("15a", "paper", alike)),
              testing::Each(true));
  EXPECT_THAT(Verdicts(CheckStatements("15b", "paper", alike)),
              testing::Each(true));
  auto one_apart = alike;
  one_apart[1] = Curve("II", true, 60, 55);
  EXPECT_EQ(Verdicts(CheckStatements("15a", "paper", one_apart)),
            (std::vector<bool>{false, true, false}));
}

TEST(SecFigures, HaveACurvePerMeasureSeedAndNoise) {
  EXPECT_THAT(MakeSecCurves("13", 3, 1, kSilent), SizeIs(4));
  EXPECT_THAT(MakeSecCurves("15a", 3, 1, kSilent), SizeIs(8));
  EXPECT_THAT(MakeSecCurves("15b", 3, 1, kSilent), SizeIs(16));
  EXPECT_THROW(MakeSecCurves("14", 3, 1, kSilent), std::invalid_argument);
}

TEST(SecFigures, AreTheSameForTheSameSeedAndStartAt1) {
  const auto csv = [](uint64_t seed) {
    return CurvesToCsv("13", 5, MakeSecCurves("13", 5, seed, kSilent));
  };
  EXPECT_EQ(csv(1), csv(1));
  EXPECT_NE(csv(1), csv(2));
  EXPECT_THAT(csv(1), HasSubstr("13,paper,Fig. 12,1,0.0,5,1.00000,0.00000\n"));
  // A line of names, then a line per curve and level.
  EXPECT_EQ(std::ranges::count(csv(1), '\n'), 1 + 4 * 11);
}

TEST(SecClasses, RateAndThresholdCountSamples) {
  SecClassesResult result{0.1, "typed", {}, {}};
  result.known = {{0.9, true}, {0.6, true}, {0.8, false}, {0.3, true}};
  result.unseen = {0.1, 0.2, 0.4, 0.6};
  EXPECT_EQ(result.num_right(), 3);
  EXPECT_EQ(result.NumAcceptedRight(0.5), 2);
  EXPECT_EQ(result.FalseAccepts(0.4), 0.5);
  // 0.9 and 0.8 win 4 each, 0.6 wins 3 and ties with one, 0.3 wins 2.
  EXPECT_DOUBLE_EQ(result.area(), (4 + 4 + 3.5 + 2) / 16);
  const double threshold = ThresholdFor(0.25, "typed", {result});
  EXPECT_LE(result.FalseAccepts(threshold), 0.25);
  EXPECT_GT(threshold, 0.4);
  EXPECT_LT(threshold, 0.41);
}

TEST(SecClasses, AreToldApartWithoutNoiseButNotBySizeNorByNoiseAlone) {
  SecClassesParams params;
  params.num_classes = 5;
  params.num_samples = 25;
  for (const auto& result : ClassifySamples(params, kSilent)) {
    const bool is_size = result.measure == "size only";
    if (result.noise == 0) {
      EXPECT_EQ(result.num_right(), is_size ? 5 : 25);
    }
    if (result.noise == 1 && result.measure != "typed") {
      EXPECT_LT(result.num_right(), 15) << result.measure;
    }
  }
}

TEST(SecGroups, AreOneModelPerManipulationWithoutNoise) {
  SecGroupsParams params;
  params.num_orders = 2;
  params.num_samples = 50;
  params.noise = 0;
  for (const auto& result : GroupSamples(params, kSilent)) {
    if (result.variant != kImprovedGrouping) continue;
    EXPECT_EQ(result.num_models, 5u);
    EXPECT_EQ(result.num_right, 50);
  }
}

class SecRecordings : public testing::Test {
 protected:
  ~SecRecordings() override { fs::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& rows) {
    const fs::path path = folder_ / (name + ".csv");
    std::ofstream(path) << "frame,hand_cup,cup_table\n" << rows;
    return path.string();
  }

  fs::path folder_ = NewTestFolder();
};

TEST_F(SecRecordings, TakeTheLabelOfTheMostSimilarOther) {
  const std::string lift = "0,0,1\n1,1,1\n2,1,0\n";
  const std::string touch = "0,0,1\n1,1,1\n2,0,1\n3,1,1\n4,0,1\n";
  const auto recordings =
      ReadRecordings({Write("lift_1", lift), Write("lift_2", lift),
                      Write("touch_1", touch), Write("touch_2", touch)},
                     0.5);
  ASSERT_THAT(recordings, SizeIs(4));
  EXPECT_EQ(recordings[2].name, "touch_1");
  EXPECT_EQ(recordings[2].label, "touch");
  EXPECT_EQ(recordings[2].chain.num_rows(), 1u) << "only what changes";
  for (const char* measure : {"typed", "paper", "size"}) {
    for (const auto& result : ClassifyLeaveOneOut(recordings, measure)) {
      EXPECT_TRUE(result.is_right) << measure;
      EXPECT_EQ(result.similarity, 1) << measure;
    }
  }
}

TEST_F(SecRecordings, ATieBetweenLabelsIsNotRight) {
  const std::string lift = "0,0,1\n1,1,1\n2,1,0\n";
  const auto results = ClassifyLeaveOneOut(
      ReadRecordings(
          {Write("a_1", lift), Write("a_2", lift), Write("b_1", lift)}, 0.5),
      "typed");
  for (const auto& result : results) EXPECT_FALSE(result.is_right);
  EXPECT_EQ(results[0].label, "");
}

TEST_F(SecRecordings, NameTheFileAndLineThatIsWrong) {
  const std::string path = Write("a_1", "0,0,1\n1,7,1\n");
  try {
    ReadRecordings({path}, 0.5);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(path + ":3: '7' is no relation"));
  }
  EXPECT_THROW(ReadRecordings({"nowhere.csv"}, 0.5), std::runtime_error);
}

}  // namespace
}  // namespace cell::cli
