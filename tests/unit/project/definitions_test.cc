// Every type has one definition. The linker takes two of the same qualified
// name in two files for one, and keeps either's destructor without a warning.
#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/unit/project/source_text.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What the text before a brace, or before a semicolon, defines.
std::string TypeIn(const std::string& head) {
  static const std::regex kType(
      R"((?:^|[\s>])(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(\w+)\s*(?:final\s*)?(?::[^:][\s\S]*)?$)");
  std::smatch match;
  return std::regex_search(head, match, kType) ? match[1].str() : "";
}

std::string AliasIn(const std::string& statement) {
  static const std::regex kAlias(R"(^\s*using\s+(\w+)\s*=)");
  std::smatch match;
  return std::regex_search(statement, match, kAlias) ? match[1].str() : "";
}

/// Calls visit(name) for every type at namespace scope that other files see.
template <class Visit>
void ForEachType(const std::string& source, Visit visit) {
  static const std::regex kNamespace(
      R"((?:^|\s)namespace(?:\s+((?:\w|::)+))?\s*$)");
  struct Scope {
    bool is_namespace = true;
    bool is_hidden = false;
    std::string name;  // with its `::`
  };
  std::vector<Scope> scopes = {{}};
  std::string head;
  for (const char c : WithoutCommentsAndTexts(source)) {
    const Scope scope = scopes.back();
    const bool is_seen = scope.is_namespace && !scope.is_hidden;
    std::smatch match;
    if (c == '{') {
      if (scope.is_namespace && std::regex_search(head, match, kNamespace)) {
        scopes.push_back({true, scope.is_hidden || !match[1].matched,
                          scope.name + match[1].str() + "::"});
      } else {
        const std::string type = TypeIn(head);
        if (is_seen && !type.empty()) visit(scope.name + type);
        scopes.push_back({false, scope.is_hidden, ""});
      }
      head.clear();
    } else if (c == '}') {
      if (scopes.size() > 1) scopes.pop_back();
      head.clear();
    } else if (c == ';') {
      const std::string alias = AliasIn(head);
      if (is_seen && !alias.empty()) visit(scope.name + alias);
      head.clear();
    } else {
      head += c;
    }
  }
}

/// "cell::Site: a.h, b.h" for every type that two files define.
std::vector<std::string> DuplicatesIn(const Sources& sources) {
  std::map<std::string, std::set<std::string>> files_of;
  for (const auto& [file, text] : sources) {
    ForEachType(text, [&, name = file](const std::string& type) {
      files_of[type].insert(name);
    });
  }
  std::vector<std::string> duplicates;
  for (const auto& [type, files] : files_of) {
    if (files.size() < 2) continue;
    std::string duplicate = type + ":";
    for (const std::string& file : files) duplicate += " " + file;
    duplicates.push_back(duplicate);
  }
  return duplicates;
}

TEST(Definitions, AreOneForEachTypeOfTheProgramsAndMessages) {
  const Sources sources = SourcesBelow({"common", "services", "lcmtypes"});
  EXPECT_GT(sources.size(), 300u);
  EXPECT_THAT(DuplicatesIn(sources), IsEmpty());
}

TEST(Definitions, OfAServiceAreInItsNamespace) {
  int num_types = 0;
  for (const auto& [file, text] : SourcesBelow({"services"})) {
    const std::string folder = *std::next(fs::path(file).begin());
    const std::string own = folder == "cell" ? "cli" : folder;
    ForEachType(text, [&, name = file](const std::string& type) {
      ++num_types;
      EXPECT_THAT(type, testing::StartsWith("cell::" + own + "::")) << name;
    });
  }
  EXPECT_GT(num_types, 100);
}

TEST(Definitions, OfAPlantedPairAreFound) {
  Sources sources = SourcesBelow({"common", "services", "lcmtypes"});
  sources["planted.h"] =
      "namespace cell {\n/// {\nstruct Site final : Base<int> {\n int x; };\n}";
  sources["planted.cc"] =
      "namespace cell {\nnamespace {\nclass Domain {};\n}  // namespace\n"
      "enum class Agent { kA };\n}  // namespace cell\n";
  EXPECT_THAT(DuplicatesIn(sources),
              ElementsAre(HasSubstr("cell::Agent: common/relational/rule.h "
                                    "planted.cc"),
                          HasSubstr("cell::Site: common/parts/part_table.h "
                                    "planted.h")));
}

TEST(Definitions, InTwoNamespacesAreTwo) {
  EXPECT_THAT(
      DuplicatesIn({{"a.h", "namespace cell { struct A {}; class B; }"},
                    {"b.h", "namespace cell::b { struct A {}; class B {}; }"},
                    {"c.h", "namespace cell { namespace { struct A {}; } }"},
                    {"d.h", "namespace cell { class B { struct A {}; }; }"}}),
      IsEmpty());
  EXPECT_THAT(
      DuplicatesIn({{"a.h",
                     "namespace cell { template <class T> class A {};"
                     "using B = int; }"},
                    {"b.h", "namespace cell { struct A {}; struct B {}; }"}}),
      ElementsAre("cell::A: a.h b.h", "cell::B: a.h b.h"));
}

}  // namespace
}  // namespace cell
