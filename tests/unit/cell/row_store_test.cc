#include "services/cell/evaluations/row_store.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "services/cell/evaluations/evaluation.h"
#include "services/cell/evaluations/excuse_figures.h"
#include "services/cell/evaluations/learning_curve.h"
#include "services/cell/evaluations/rexd_blocks.h"
#include "tests/test_folder.h"

namespace cell {

using namespace cli;
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class RowStoreTest : public testing::Test {
 protected:
  void SetUp() override { identity_.AddFile("the task file", "a task"); }
  void TearDown() override { std::filesystem::remove_all(file_.parent_path()); }

  RowStore::Params Params(bool is_resumed = true) const {
    return {.path = file_,
            .is_resumed = is_resumed,
            .identity = identity_,
            .shape = RowShape::Record({{"size", RowShape::kWhole}})};
  }
  std::string Text() const {
    std::ifstream file(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void Write(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
  }
  /// With the rows a and b, of the sizes 1 and 2.
  void WriteRows() const {
    RowStore store(Params(false));
    store.Append("a", {{"size", 1}});
    store.Append("b", {{"size", 2}});
  }
  /// What is said of a file that is refused and stays as it is.
  std::string Refused() const {
    const std::string before = Text();
    std::string said;
    try {
      RowStore store(Params());
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    EXPECT_EQ(Text(), before);
    EXPECT_THAT(said, HasSubstr(file_.string() + ": "));
    EXPECT_THAT(said, HasSubstr("--rows"));
    EXPECT_THAT(said, Not(HasSubstr("json.exception")));
    return said;
  }

  const std::filesystem::path file_ = NewTestFolder() / "rows";
  RowIdentity identity_{"eval rexd", {{"--teacher", "sure"}}, {}};
};

TEST_F(RowStoreTest, KeepsRowsThatWereMadeInTheSameWay) {
  WriteRows();
  const std::string before = Text();
  const RowStore store(Params());
  EXPECT_EQ(Text(), before);
  EXPECT_EQ(store.At("b").at("size"), 2);
  EXPECT_EQ(store.RowsOf({"b", "c", "a"}).size(), 2u);
}

TEST_F(RowStoreTest, NamesTheOptionOrFileThatIsAnother) {
  WriteRows();
  const RowIdentity mine = identity_;
  identity_.options["--teacher"] = "noisy";
  EXPECT_THAT(Refused(), HasSubstr("--teacher was sure, now it is noisy"));
  identity_ = mine;
  identity_.AddFile("the task file", "another task");
  EXPECT_THAT(Refused(), HasSubstr("the task file is another"));
  identity_ = mine;
  identity_.AddFile("tasks/new.yaml", "");
  EXPECT_THAT(Refused(), HasSubstr("tasks/new.yaml is new"));
  identity_.files.clear();
  EXPECT_THAT(Refused(), HasSubstr("the task file is gone"));
  identity_.command = "eval watch";
  EXPECT_THAT(Refused(), HasSubstr("'cell eval rexd', not of 'cell eval wat"));
}

TEST_F(RowStoreTest, RefusesRowsThatDoNotSayWhatTheyAreOf) {
  Write("{\"key\":\"a\",\"size\":1}\n");
  EXPECT_THAT(Refused(), HasSubstr("first line"));
}

TEST_F(RowStoreTest, DropsWhatACrashLeftOfTheLastLine) {
  WriteRows();
  const std::string whole = Text();
  const size_t last = whole.rfind("{\"key\"");
  for (const size_t end : {last + 1, last + 5, whole.size() - 2}) {
    Write(whole.substr(0, end));
    RowStore store(Params());
    EXPECT_TRUE(store.Has("a"));
    EXPECT_FALSE(store.Has("b")) << end;
    store.Append("b", {{"size", 2}});
    EXPECT_EQ(Text(), whole);
  }
  // Of the first line, and of an end of line alone.
  for (const size_t end : {size_t{5}, whole.size() - 1}) {
    Write(whole.substr(0, end));
    RowStore store(Params());
    for (const char* key : {"a", "b"}) {
      if (!store.Has(key)) store.Append(key, {{"size", 1 + (*key - 'a')}});
    }
    EXPECT_EQ(Text(), whole);
  }
}

TEST_F(RowStoreTest, LeavesFilesThatHoldNoRowsAsTheyAre) {
  for (const char* text :
       {"{\"calibration\": [1, 2, 3]}", "{\"calibration\": [1, 2, 3]}\n",
        "{my notes", "my notes", "[]", "7", "\n"}) {
    Write(text);
    EXPECT_THAT(Refused(), HasSubstr("line 1")) << text;
  }
  Write("");
  WriteRows();
  Write(Text() + "{\"calibration\": [1, 2, 3]}");
  EXPECT_THAT(Refused(), HasSubstr("line 4"));
}

TEST_F(RowStoreTest, NamesTheFieldThatIsNotAsItShouldBe) {
  WriteRows();
  const std::string whole = Text();
  for (const auto& [row, said] :
       {std::pair(R"({"key":"c"})", "size: is missing, should be a whole"),
        std::pair(R"({"key":"c","size":"x"})", R"(whole number of at most 32)"),
        std::pair(R"({"key":"c","size":1e300})", "is 1e+300"),
        std::pair(R"({"key":"c","size":null})", "is null")}) {
    Write(whole + row + "\n");
    EXPECT_THAT(Refused(),
                AllOf(HasSubstr("line 4: row 'c': size: "), HasSubstr(said)));
  }
  Write(whole);
  RowStore store(Params());
  EXPECT_THROW(store.Append("d", {{"size", "x"}}), std::runtime_error);
  EXPECT_EQ(Text(), whole);
}

TEST(RowShape, TellsWhereAValueIsOfAnotherShape) {
  using enum RowShape::Kind;
  const RowShape shape = RowShape::Record(
      {{"seed", kSeed},
       {"stops", RowShape::ListOf(RowShape::Record({{"moved", kNumber}}))},
       {"p", RowShape::MapOf(RowShape::ListOf(kWhole, 2))}});
  const json good = {{"seed", UINT64_MAX},
                     {"stops", {{{"moved", 1}}, {{"moved", 0.5}}}},
                     {"p", {{"lift", {1, -2}}}}};
  EXPECT_EQ(MisfitOf(good, shape), std::nullopt);
  const auto misfit = [&](const std::string& where, const json& value) {
    json bad = good;
    bad[json::json_pointer(where)] = value;
    return MisfitOf(bad, shape).value_or("");
  };
  EXPECT_EQ(misfit("/seed", -2),
            "seed: should be a whole number from 0 on of at most 64 bits, is "
            "-2");
  EXPECT_EQ(misfit("/stops/1/moved", "x"),
            "stops[1].moved: should be a number, is \"x\"");
  EXPECT_EQ(misfit("/p/lift", {1}),
            "p.lift: should be a list of 2, is a list of 1");
  EXPECT_EQ(misfit("/p/lift/0", 1LL << 31),
            "p.lift[0]: should be a whole number of at most 32 bits, is "
            "2147483648");
}

/// The least that a value of the shape can be: lists and maps have what they
/// must, and one entry otherwise.
json LeastOf(const RowShape& shape) {
  switch (shape.kind) {
    case RowShape::kFlag:
      return false;
    case RowShape::kText:
      return "";
    case RowShape::kList:
      return json::array_t(shape.length.value_or(1), LeastOf(shape.each[0]));
    case RowShape::kMap:
    case RowShape::kRecord: {
      json value = json::object();
      for (const auto& [name, field] : shape.fields) {
        value[name] = LeastOf(field);
      }
      if (!shape.each.empty()) value["any"] = LeastOf(shape.each[0]);
      return value;
    }
    default:
      return 0;
  }
}

// Every field that is read is checked when a file of rows is loaded.
TEST(RowShapes, HoldAllThatIsReadOfARow) {
  for (const auto& evaluation : AllEvaluations()) {
    std::vector<json> rows;
    for (const TrialGroup& group : evaluation->groups()) {
      rows.push_back(LeastOf(evaluation->row_shape()));
      rows.back()["group"] = group.name;
    }
    EXPECT_NO_THROW(evaluation->Measures(rows)) << evaluation->name();
    EXPECT_NO_THROW(evaluation->Figures(rows)) << evaluation->name();
  }
  EXPECT_NO_THROW(SummariseExcuses({LeastOf(ExcuseRowShape())}));
  const json curve = LeastOf(CurveRowShape(3));
  EXPECT_NO_THROW(LearningCurve({curve}, 1, 1));
  EXPECT_NO_THROW(ActionsToMaster(curve, 1, 1));
  const RexdGroup runs{1, {LeastOf(RexdRowShape(3))}};
  EXPECT_NO_THROW(RexdText(runs, 3, 8));
  EXPECT_NO_THROW(RexdCsv({runs}, 3));
  EXPECT_NO_THROW(CheckRexdStatements({runs}, 3, 8));
  const BlockPlan plan{{"first", "second"}, {4, 5}, 2};
  const RexdGroup blocks{1, {LeastOf(BlocksRowShape(plan))}};
  EXPECT_NO_THROW(BlocksText(plan, blocks));
  EXPECT_NO_THROW(BlocksCsv(plan, {blocks}));
  EXPECT_NO_THROW(CheckBlockStatements(plan, blocks));
}

}  // namespace
}  // namespace cell
