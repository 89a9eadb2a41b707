#include "common/config/config.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

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
            "toy.yaml:a.c: missing (line 1)");
  EXPECT_EQ(
      ErrorOf([&] { config["a"].Get<int>("b"); }),
      "toy.yaml:a.b: cannot be read as a whole number: 'x' is not a whole "
      "number (line 1)");
  EXPECT_THAT(ErrorOf([&] { config["a"].Numbers("list", 3); }),
              HasSubstr("toy.yaml:a.list: needs 3 numbers, has 2"));
  EXPECT_THAT(ErrorOf([&] { config.Number("n", 0, 10); }),
              HasSubstr("toy.yaml:n: 11 lies outside [0, 10]"));
}

TEST(Config, RefusesUnreadKeys) {
  const Config config = Config::Parse("a: {b: 1, typo: 2}", "toy.yaml");
  config["a"].Get<int>("b");
  EXPECT_THAT(ErrorOf([&] { config.Finish(); }),
              HasSubstr("toy.yaml:a.typo: not known"));
}

TEST(Config, RefusesUnreadKeysInsideLists) {
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
              HasSubstr("'.nan' is not a finite number"));
  EXPECT_THAT(ErrorOf([&] { config.Numbers("list", 2); }),
              HasSubstr("toy.yaml:list[1]: "));
}

TEST(Config, RefusesUnreadKeysInMixedLists) {
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

// What YAML allows but is a mistake here, each with the line that has it.
TEST(Config, RefusesYamlThatIsProbablyAMistake) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"a: 1\nb: {c: 1, c: 2}\n", "toy.yaml:b.c: the key already exists"},
      {"a: 1\na: 2\n", "(line 2)"},
      {"x:\n  ? [1, 2]\n  : y\n",
       "toy.yaml:x: a map or a list cannot be a key"},
      {"{{a: 1}: 2}\n", "cannot be a key (line 1)"},
      {"x: &a {b: 1}\ny:\n  <<: *a\n",
       "toy.yaml:y.<<: merge keys (<<: *anchor) are not supported; write the "
       "keys out (line 3)"},
      {"x: !!int 3\n", "toy.yaml:x: tags"},
      {"x: !mine {a: 1}\n", "toy.yaml:x: tags"},
      {"x: 1\n---\ny: 2\n",
       "a second document begins; only one is allowed (line 2)"},
      {"x: 1\n...\ny: 2\n", "a second document"},
      {"x: &a [1, *a]\n", "refers to a value that contains it"},
      {"x: &a 1\ny: &a 2\n", "the anchor &a already exists (line 2)"},
      {"x: *a\n", "toy.yaml:1: not YAML"},
      {"~: 1\n", "a key is empty"},
      {"x:\n  y:\n\t  z: 1\n", "indented by a tab"},
      {"x: \"a\n", "toy.yaml"},
      {"x: 'a\n", "toy.yaml"},
      {"x: [a, b\n", "toy.yaml"},
      {"", "toy.yaml: is empty"},
      {"# nothing\n", "toy.yaml: is empty"},
      {std::string("x: a\0b\n", 7), "the byte 0x00 is not text"},
      {"x: \"\\0\"\n", "contains the character 0"},
      {"x: 1\ny: \xff\n", "the byte 0xff is not text in UTF-8 (line 2)"},
      {"x: \xc0\xaf\n", "is not text in UTF-8"},
      {"x: \xed\xa0\x80\n", "is not text in UTF-8"},
      {"x: [fits(X, Y), Clear(X)]\n", "toy.yaml:x[0]: 'fits(X' is cut off"},
      {"x: [not fits(X, Y)]\n", "needs quotes: \"Name(X, Y)\" (line 1)"},
      {"x:\n  {fits(X, Y): true}\n",
       "it needs quotes: \"Name(X, Y)\" (line 2)"},
      {"x: " + std::string(70, '[') + std::string(70, ']') + "\n",
       "is nested deeper"},
      {"x: " + std::string(100'000, '[') + "\n", "toy.yaml"},
  };
  for (const auto& [text, what] : cases) {
    EXPECT_THAT(ErrorOf([&] { Config::Parse(text, "toy.yaml"); }),
                HasSubstr(what))
        << text.substr(0, 80);
  }
}

TEST(Config, RefusesAliasesThatStandForMoreThanMemoryHolds) {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    text += fmt::format("a{0}: &a{0} [{1}, {1}, {1}, {1}, {1}, {1}, {1}]\n", i,
                        last);
  }
  EXPECT_THAT(ErrorOf([&] { Config::Parse(text, "toy.yaml"); }),
              HasSubstr("toy.yaml:a"));
}

TEST(Config, ReadsNumbersAsAPersonDoes) {
  const auto error_of = [](const std::string& value, auto type) {
    using T = decltype(type);
    const Config config = Config::Parse("x: 1\nn: " + value, "toy.yaml");
    return ErrorOf([&] { config.Get<T>("n"); });
  };
  for (const std::string text :
       {"0100", "-07", "0x10", "0o17", "1_000", "1:30", "1.0", "1e3", "7mm",
        "2147483648", "-2147483649", "1,5", "--1", "+-1", "+", "''", "yes"}) {
    EXPECT_THAT(error_of(text, int{}),
                testing::AllOf(HasSubstr("toy.yaml:n: cannot be read as a"),
                               HasSubstr("(line 2)")))
        << text;
  }
  for (const std::string text :
       {"-1", "18446744073709551616", "010", "99999999999999999999"}) {
    EXPECT_THAT(error_of(text, uint64_t{}), HasSubstr("toy.yaml:n: ")) << text;
  }
  for (const std::string text :
       {"1e999", "-1e999", "007.5", "0x1p3", "1.5mm", "1,5", "inf", ".inf",
        "-.inf", "nan", ".NaN", "1:30", "[1]", "{a: 1}"}) {
    EXPECT_THAT(error_of(text, double{}), HasSubstr("toy.yaml:n: ")) << text;
  }
  for (const std::string text : {"yes", "no", "on", "off", "y", "TRUE", "1"}) {
    EXPECT_THAT(error_of(text, bool{}),
                HasSubstr("cannot be read as true or false"))
        << text;
  }
  const Config good = Config::Parse(
      "\xEF\xBB\xBF{a: -7, b: +5, c: 2.0e-5, d: .5, e: 0, f: 0.5, g: true, "
      "h: 18446744073709551615}",
      "toy.yaml");
  EXPECT_EQ(good.Get<int>("a"), -7);
  EXPECT_EQ(good.Get<int>("b"), 5);
  EXPECT_EQ(good.Get<double>("c"), 2e-5);
  EXPECT_EQ(good.Get<double>("d"), 0.5);
  EXPECT_EQ(good.Get<int>("e"), 0);
  EXPECT_EQ(good.Get<double>("f"), 0.5);
  EXPECT_TRUE(good.Get<bool>("g"));
  EXPECT_EQ(good.Get<uint64_t>("h"), UINT64_MAX);
}

TEST(Config, NamesTheLineOfWhatIsWrong) {
  const Config config =
      Config::Parse("a:\n  b: 1\n  list:\n    - 1\n    - x\nz: 1\n", "t.yaml");
  EXPECT_EQ(ErrorOf([&] { config["a"].Numbers("list", 2); }),
            "t.yaml:a.list[1]: cannot be read as a number: 'x' is not a number "
            "(line 5)");
  EXPECT_THAT(
      ErrorOf([&] { config["a"].Finish(); }),
      HasSubstr("t.yaml:a.b: not known; remove it or correct its spelling "
                "(line 2)"));
  EXPECT_EQ(ErrorOf([&] { config["a"]["list"].Get<int>("x"); }),
            "t.yaml:a.list: should be a map with the key 'x' (line 3)");
}

}  // namespace
}  // namespace cell
