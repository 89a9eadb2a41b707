#include "common/rules/data_text.h"

#include <gmock/gmock.h>

#include "common/rules/rule_error.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

using testing::HasSubstr;

constexpr char kDataSymbols[] = R"(
grab 1 action
on 2 primitive
table 1 primitive
size 1 primitive integers
clear 1 conjunction <-- All Y -on(Y X)
above 2 transclosure <-- + on
height 1 count <-- Num Y above(X Y)
total 0 sum <-- Sum height
stacked 1 conjunction <-- Some Y on(X Y) -table(Y)
)";

std::string DataErrorOf(const std::string& data) {
  try {
    ExperiencesFrom(kDataSymbols, data);
  } catch (const RuleError& error) {
    return error.what();
  }
  return "no error";
}

std::string SymbolErrorOf(const std::string& symbols) {
  try {
    SymbolTable::Parse(symbols, "s");
  } catch (const RuleError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Data, ConsistsOfStatesAndActionsInTurn) {
  const ExperienceSet set = ExperiencesFrom(kDataSymbols,
                                            "# t=0\n"
                                            "on(a b) size(a)=3\n"
                                            "grab(a)\n"
                                            "table(b) size(a)=3\n"
                                            "grab(b)\n"
                                            "size(a)=4 table(b)\n"
                                            "on(c a)\n"
                                            "grab(c)\n"
                                            "on(c b)\n");
  ASSERT_EQ(set.experiences.size(), 3u);
  EXPECT_EQ(ToText(set.experiences[0].before, *set.world),
            "on(a, b) size(a)=3");
  EXPECT_EQ(set.world->Show(set.experiences[1].act.action,
                            set.experiences[1].act.arguments),
            "grab(b)");
  EXPECT_EQ(set.experiences[0].after, set.experiences[1].before);
  EXPECT_EQ(ToText(set.experiences[2].before, *set.world), "on(c, a)");
}

TEST(Data, IsReadBackAsItWasWritten) {
  const ExperienceSet set = ExperiencesFrom(
      kDataSymbols, "on(a b) size(a)=-3\ngrab(a)\non(b a)\ngrab(b)\non(b a)\n");
  const ExperienceSet again = ExperiencesFrom(kDataSymbols, ToText(set));
  EXPECT_EQ(set.experiences, again.experiences);
}

TEST(Data, DerivedSymbolsFollowTheirDefinitions) {
  const World world(SymbolsFrom(kDataSymbols), ObjectsFrom("tabc"));
  const WorldState state =
      ParseState("table(t) on(a t) on(b a) on(c b)", "d", 1, world);
  const auto holds = [&](const char* name, std::vector<int> objects) {
    return World::Get(state,
                      world.PlaceOf(*world.symbols().Find(name), objects));
  };
  const auto value = [&](const char* name, std::vector<int> objects) {
    return state.values[static_cast<size_t>(
        world.PlaceOf(*world.symbols().Find(name), objects))];
  };
  EXPECT_TRUE(holds("clear", {3}));
  EXPECT_FALSE(holds("clear", {2}));
  EXPECT_TRUE(holds("above", {3, 0}));
  EXPECT_FALSE(holds("above", {0, 3}));
  EXPECT_FALSE(holds("above", {3, 3}));
  EXPECT_EQ(value("height", {3}), 3);
  EXPECT_EQ(value("total", {}), 3 + 2 + 1);
  EXPECT_TRUE(holds("stacked", {2}));
  EXPECT_FALSE(holds("stacked", {1}));
}

TEST(Data, NothingHoldsOfObjectsThatAStateDoesNotName) {
  const World world(SymbolsFrom(kDataSymbols), ObjectsFrom("ab"));
  const WorldState state = ParseState("table(a)", "d", 1, world);
  const int clear = *world.symbols().Find("clear");
  EXPECT_TRUE(World::Get(state, world.PlaceOf(clear, std::vector<int>{0})));
  EXPECT_FALSE(World::Get(state, world.PlaceOf(clear, std::vector<int>{1})));
}

TEST(Data, ErrorsNameFileAndLineAndWhatIsRight) {
  EXPECT_THAT(DataErrorOf("on(a b)\ngrab(a)\nonn(a b)\n"),
              HasSubstr("d:3: there is no symbol 'onn'; did you mean 'on'?"));
  EXPECT_THAT(DataErrorOf("on(a)\n"),
              HasSubstr("d:1: 'on' has 2 arguments, not 1"));
  EXPECT_THAT(DataErrorOf("size(a)\n"), HasSubstr("its value is missing"));
  EXPECT_THAT(DataErrorOf("on(a b)=3\n"), HasSubstr("'on' is not a function"));
  EXPECT_THAT(DataErrorOf("size(a)=x\n"), HasSubstr("a whole number"));
  EXPECT_THAT(DataErrorOf("size(a)=1 size(a)=2\n"),
              HasSubstr("d:1: size(a) is 1 and 2"));
  EXPECT_THAT(DataErrorOf("grab(a)\n"),
              HasSubstr("d:1: an action follows the state before it"));
  EXPECT_THAT(DataErrorOf("on(a b)\ngrab(a)\n"),
              HasSubstr("d:2: the state after this action is missing"));
  EXPECT_THAT(DataErrorOf("on(a b)\ngrab(c)\non(a b)\n"),
              HasSubstr("d:2: the state before says nothing of 'c'"));
  EXPECT_THAT(DataErrorOf("on(A b)\n"), HasSubstr("d:1: 'A' should begin"));
  EXPECT_THAT(DataErrorOf("on(a b\n"), HasSubstr("the end of the line"));
}

TEST(Symbols, AreReadBackAsTheyWereWritten) {
  const auto symbols = SymbolTable::Parse(
      std::string(kDataSymbols) +
          "tray 0 constant\nput 2 action <-- table(X) -on(X Y)\n",
      "s");
  EXPECT_EQ(SymbolTable::Parse(symbols.ToText(), "s"), symbols);
}

TEST(Symbols, ErrorsNameFileAndLine) {
  EXPECT_THAT(SymbolErrorOf("\non 2 primitve\n"),
              HasSubstr("s:2: 'primitve' is no kind of symbol; did you mean "
                        "'primitive'?"));
  EXPECT_THAT(SymbolErrorOf("on 4 primitive\n"),
              HasSubstr("0 to 3 are possible"));
  EXPECT_THAT(SymbolErrorOf("on 2 primitive\non 2 primitive\n"),
              HasSubstr("s:2: 'on' is declared twice"));
  EXPECT_THAT(SymbolErrorOf("clear 1 conjunction <-- All Y -on(Y X)\n"),
              HasSubstr("there is no predicate or function 'on' before"));
  EXPECT_THAT(SymbolErrorOf("clear 1 conjunction\n"),
              HasSubstr("needs a definition"));
  EXPECT_THAT(SymbolErrorOf("on 2 primitive\nabove 1 transclosure <-- + on\n"),
              HasSubstr("'above' should be declared as"));
}

}  // namespace
}  // namespace cell::rules
