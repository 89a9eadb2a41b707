// What a person is asked for, in words of the domain.
#include "common/relational/request_words.h"

#include <gmock/gmock.h>

#include "common/relational/domain.h"

namespace cell {
namespace {

using testing::HasSubstr;

constexpr char kDomain[] = R"yaml(
types: {bolt: object, hole: object}
constants: {bolt_1: bolt, hole_1: hole}
predicates:
  In: {arguments: [bolt, hole]}
  Free: {arguments: [hole]}
actions:
  Insert: {arguments: {X: bolt, Y: hole}, rules: []}
goals: {done: ["In(bolt_1, hole_1)"]}
)yaml";

Domain LoadWords(const std::string& requests) {
  const Config config =
      Config::Parse(kDomain + ("requests:\n" + requests), "domain.yaml");
  Domain domain = Domain::FromConfig(config, PartTable{});
  config.Finish();
  return domain;
}

std::string WordsErrorOf(const std::string& requests) {
  try {
    LoadWords(requests);
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "none";
}

TEST(RequestWords, NameTheObjects) {
  const Domain domain = LoadWords(R"yaml(
  make_true: {Free: "empty {0}, all of {0}"}
  make_false: {In: "take the {0} out of {1}"}
  do: {Insert: "put the {0} into {1}"}
)yaml");
  const Vocabulary& words = domain.vocabulary();
  const int bolt = *words.FindObject("bolt_1");
  const int hole = *words.FindObject("hole_1");
  const int free = *words.FindPredicate("Free");
  const int in = *words.FindPredicate("In");
  const RequestWords& requests = domain.requests();
  EXPECT_EQ(requests.ToMake({free, {hole}}, true, words),
            "empty hole_1, all of hole_1");
  EXPECT_EQ(requests.ToMake({free, {hole}}, false, words), std::nullopt);
  EXPECT_EQ(requests.ToMake({in, {bolt, hole}}, false, words),
            "take the bolt_1 out of hole_1");
  EXPECT_EQ(requests.ToDo("Insert", {bolt, hole}, words),
            "put the bolt_1 into hole_1");
  EXPECT_EQ(requests.ToDo("Remove", {bolt, hole}, words), std::nullopt);
}

TEST(RequestWords, OfWhatIsNotThereAreNamedWithTheNearest) {
  EXPECT_THAT(WordsErrorOf("  make_true: {Fre: \"empty {0}\"}\n"),
              testing::AllOf(HasSubstr("domain.yaml:requests.make_true.Fre"),
                             HasSubstr("did you mean 'Free'?")));
  EXPECT_THAT(WordsErrorOf("  do: {Insret: \"put\"}\n"),
              HasSubstr("there is no action of this name; did you mean "
                        "'Insert'?"));
  EXPECT_THAT(WordsErrorOf("  done: {Insert: \"put\"}\n"), HasSubstr("done"));
}

TEST(RequestWords, HaveNoPlaceForAnArgumentThatIsNotThere) {
  EXPECT_THAT(WordsErrorOf("  make_true: {Free: \"empty {1}\"}\n"),
              HasSubstr("its arguments are {0}"));
  EXPECT_THAT(WordsErrorOf("  do: {Insert: \"put {X} in\"}\n"),
              HasSubstr("its arguments are {0}, {1}"));
}

}  // namespace
}  // namespace cell
