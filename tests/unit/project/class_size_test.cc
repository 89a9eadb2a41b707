// No class has more data members than a reader keeps in mind: what has more
// hides a state machine, or another class.
#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "tests/unit/project/source_text.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kMaxMembers = 15;

struct ClassSize {
  std::string name;
  int num_members = 0;
};

/// Without what stands in brackets of one kind, to any depth.
std::string Without(const std::string& text, char open, char close) {
  std::string rest;
  int depth = 0;
  for (const char c : text) {
    if (c == open) ++depth;
    if (depth == 0) rest += c;
    if (c == close && depth > 0) --depth;
  }
  return rest;
}

std::string Trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \n\t");
  const size_t end = text.find_last_not_of(" \n\t");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// The declaration that a statement begins with, without template arguments
/// and access specifiers.
std::string Declaration(const std::string& statement) {
  static const std::regex kAccess(R"(\b(public|private|protected)\s*:(?!:))");
  return Trimmed(
      Without(std::regex_replace(statement, kAccess, " "), '<', '>'));
}

/// The data members that a statement of a class declares. `<>` and the braces
/// of initialisers are gone.
int MembersIn(const std::string& statement) {
  static const std::regex kOther(
      R"(^(using|typedef|friend|static|constexpr|template|enum|explicit|virtual|union|inline)\b|\boperator\b|^(class|struct)\s+\w+$)");
  static const std::regex kPlain(R"([\w:\]*&]\s+[*&]?\w)");
  const std::string declaration = Declaration(statement);
  const std::string before =
      Trimmed(declaration.substr(0, declaration.find('=')));
  if (before.empty() || before.find('(') != std::string::npos ||
      std::regex_search(before, kOther) || !std::regex_search(before, kPlain)) {
    return 0;
  }
  const std::string names = Without(Without(declaration, '(', ')'), '[', ']');
  return 1 + static_cast<int>(std::ranges::count(names, ','));
}

/// Of every class in the source, also of those within others and functions.
std::vector<ClassSize> ClassesIn(const std::string& source) {
  static const std::regex kType(
      R"((?:^|[\s>])(?:class|struct)\s+(\w+)\s*(?:final\s*)?(?::[^:][\s\S]*)?$)");
  enum class Scope { kClass, kInitialiser, kOther };
  struct Open {
    Scope scope = Scope::kOther;
    ClassSize size;
    std::string head;  // what its closing brace ends, if more may follow
  };
  std::vector<ClassSize> classes;
  std::vector<Open> open;
  std::string head;
  const auto is_in_class = [&] {
    return !open.empty() && open.back().scope == Scope::kClass;
  };
  for (const char c : WithoutCommentsAndTexts(source)) {
    std::smatch match;
    if (c == '{') {
      const std::string declaration = Declaration(head);
      const std::string before = declaration.substr(0, declaration.find('='));
      const bool is_enum =
          std::regex_search(declaration, std::regex(R"(\benum\b)"));
      if (!is_enum && std::regex_search(declaration, match, kType)) {
        open.push_back({Scope::kClass, {match[1].str()}, "Type "});
      } else if (is_in_class() && !is_enum && !Trimmed(before).empty() &&
                 before.find('(') == std::string::npos &&
                 before.find("operator") == std::string::npos) {
        open.push_back({Scope::kInitialiser, {}, head});
      } else {
        open.push_back({Scope::kOther, {}, is_enum ? "Type " : ""});
      }
      head.clear();
    } else if (c == '}' && !open.empty()) {
      if (open.back().scope == Scope::kClass) {
        classes.push_back(open.back().size);
      }
      head = open.back().head;
      open.pop_back();
    } else if (c == ';') {
      if (is_in_class()) open.back().size.num_members += MembersIn(head);
      head.clear();
    } else {
      head += c;
    }
  }
  return classes;
}

int MembersOfOnly(const std::string& source) {
  const std::vector<ClassSize> classes = ClassesIn(source);
  return classes.size() == 1 ? classes[0].num_members : -1;
}

TEST(ClassSize, IsOfFifteenMembersAtMost) {
  int num_classes = 0;
  int num_members = 0;
  for (const auto& [file, text] : SourcesBelow({"common", "services"})) {
    for (const ClassSize& size : ClassesIn(text)) {
      ++num_classes;
      num_members += size.num_members;
      EXPECT_LE(size.num_members, kMaxMembers) << size.name << " in " << file;
    }
  }
  // Or the reading is broken.
  EXPECT_GT(num_classes, 300);
  EXPECT_GT(num_members, 1000);
}

TEST(ClassSize, CountsEveryWayToDeclareAMember) {
  EXPECT_EQ(MembersOfOnly("struct A { int a; };"), 1);
  EXPECT_EQ(MembersOfOnly("struct A { int a = 0, b, *c = nullptr; };"), 3);
  EXPECT_EQ(MembersOfOnly("struct A { double a[2] = {1, 2}; B b{1, {2}}; };"),
            2);
  EXPECT_EQ(MembersOfOnly("class A final : public B<int, 2> {\n public:\n"
                          " private:\n  std::map<int, std::pair<B, C>> a_;\n"
                          "  const D& d_;  // e; f\n};"),
            2);
  EXPECT_EQ(MembersOfOnly("struct A { std::function<void(int)> f = {}; };"), 1);
  EXPECT_EQ(MembersOfOnly("struct A { B b = Of(1, 2), c = B::D(); };"), 2);
  EXPECT_EQ(MembersOfOnly("struct A { enum class E { a, b } e = E::a; };"), 1);
  EXPECT_EQ(MembersOfOnly("struct A { double x = 1'000, y = 2; };"), 2);
}

TEST(ClassSize, CountsNothingElse) {
  EXPECT_EQ(MembersOfOnly("class A { A(int b) : b_{b}, c_(2) { int d; }\n"
                          "  void F(int a, int b) const; void G() { int x; }\n"
                          "  virtual int H() = 0; A(const A&) = delete;\n"
                          "  bool operator==(const A&) const = default;\n"
                          "  explicit operator bool() const { int y; } };"),
            0);
  EXPECT_EQ(MembersOfOnly("struct A { static constexpr int kA = 1, kB = 2;\n"
                          "  using B = int; enum class C { a, b = 2 };\n"
                          "  friend class D; class E;\n"
                          "  template <class T> void F() { int z; } };"),
            0);
}

TEST(ClassSize, IsToldOfEachClassApart) {
  const auto classes = ClassesIn(
      "namespace a { class A { struct B { int x, y; }; B b_; std::vector<B> c_;"
      " int d_; }; void F() { struct C { int z; }; C c{1}; } }");
  std::vector<std::string> told;
  for (const ClassSize& size : classes) {
    told.push_back(size.name + " " + std::to_string(size.num_members));
  }
  EXPECT_THAT(told, ElementsAre("B 2", "A 3", "C 1"));
  EXPECT_THAT(ClassesIn("enum class E { a }; void F(struct tm* t) { int u; }"),
              IsEmpty());
}

}  // namespace
}  // namespace cell
