#include "common/config/config.h"

#include <gmock/gmock.h>

namespace cell {
namespace {

using testing::HasSubstr;

template <class F>
std::string ErrorOf(F f) {
  try {
    f();
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Config, NamesFileAndKeyOfWhatIsMissingOrMalformed) {
  const Config config =
      Config::Parse("a: {b: x, list: [1, 2]}\nn: 11", "toy.yaml");
  EXPECT_EQ(ErrorOf([&] { config["a"].Get<int>("c"); }),
            "toy.yaml:a.c: missing");
  EXPECT_EQ(ErrorOf([&] { config["a"].Get<int>("b"); }),
            "toy.yaml:a.b: cannot be read as a whole number: 'x'");
  EXPECT_THAT(ErrorOf([&] { config["a"].Numbers("list", 3); }),
              HasSubstr("toy.yaml:a.list: needs 3 numbers, has 2"));
  EXPECT_THAT(ErrorOf([&] { config.Number("n", 0, 10); }),
              HasSubstr("toy.yaml:n: 11 lies outside [0, 10]"));
}

TEST(Config, RefusesKeysThatNobodyRead) {
  const Config config = Config::Parse("a: {b: 1, typo: 2}", "toy.yaml");
  config["a"].Get<int>("b");
  EXPECT_THAT(ErrorOf([&] { config.Finish(); }),
              HasSubstr("toy.yaml:a.typo: not known"));
}

TEST(Config, RefusesKeysThatNobodyReadInsideLists) {
  const Config config =
      Config::Parse("list: [{a: 1}, {a: 1, typo: 2}]", "toy.yaml");
  for (const Config& item : config["list"].Items()) item.Get<int>("a");
  EXPECT_THAT(ErrorOf([&] { config.Finish(); }),
              HasSubstr("toy.yaml:list[1].typo: not known"));
}

TEST(Config, RefusesEmptyValuesAndNumbersThatAreNotFinite) {
  const Config config =
      Config::Parse("empty:\nn: .nan\nlist: [1, .inf]", "toy.yaml");
  EXPECT_THAT(ErrorOf([&] { config.Get<std::string>("empty"); }),
              HasSubstr("toy.yaml:empty: is empty, should be text"));
  EXPECT_THAT(ErrorOf([&] { config.Get<double>("n"); }),
              HasSubstr("toy.yaml:n: is not a finite number"));
  EXPECT_THAT(ErrorOf([&] { config.Numbers("list", 2); }),
              HasSubstr("toy.yaml:list: has a number that is not finite"));
}

TEST(Config, RefusesKeysThatNobodyReadInMixedLists) {
  const Config config = Config::Parse("list: [x, {a: 1, typo: 2}]", "toy.yaml");
  config["list"].Items()[1].Get<int>("a");
  EXPECT_THAT(ErrorOf([&] { config.Finish(); }),
              HasSubstr("toy.yaml:list[1].typo: not known"));
}

TEST(Config, SaysWhatIsNotYamlOrNotThere) {
  EXPECT_THAT(ErrorOf([] { Config::Parse("a: [", "toy.yaml"); }),
              HasSubstr("toy.yaml:"));
  EXPECT_THAT(ErrorOf([] { Config::Load("/nonexistent.yaml"); }),
              HasSubstr("/nonexistent.yaml: cannot be opened"));
}

}  // namespace
}  // namespace cell
