#include "services/library/experience_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/library/content_json.h"
#include "tests/unit/library/some_experiences.h"

namespace cell {

using namespace library;
namespace {

using testing::HasSubstr;

LibraryContent SomeContent() {
  LibraryContent content;
  for (int i = 1; i <= 5; ++i) {
    content.experiences.push_back(Tried("Action" + std::to_string(i), i));
    content.experiences.back().id = 2 * i;
  }
  content.last_experience = 12;
  return content;
}

std::string ComplaintOf(const std::string& from, const std::string& to) {
  std::string text = TextOfContent(SomeContent());
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  try {
    ContentFromText(text.replace(at, from.size(), to), "a.json");
    return "";
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
}

TEST(ExperienceJson, IsReadBackAsItWas) {
  const LibraryContent content = SomeContent();
  const LibraryContent read = ContentFromText(TextOfContent(content), "a.json");
  EXPECT_EQ(read.experiences, content.experiences);
  EXPECT_EQ(read.last_experience, 12);
}

TEST(ExperienceJson, AnExperienceIsTheSameAfterItsMessage) {
  ExperienceRecord experience = Tried("Insert", 3);
  experience.id = 7;
  experience.before.push_back("On(a.top, b.left)");
  experience.demonstration.clear();  // the message does not say it
  EXPECT_EQ(ToRecord(ToMessage(experience)), experience);
}

TEST(ExperienceJson, IsReadStrictly) {
  EXPECT_EQ(ComplaintOf("\"id\"", "\"id\""), "");
  EXPECT_THAT(ComplaintOf("\"before\"", "\"earlier\""),
              HasSubstr("a.json:experiences[0].earlier: not known"));
  EXPECT_THAT(ComplaintOf("\"Clear(separator)\"", "7"),
              HasSubstr("a.json:experiences[0].before: should be a list of "
                        "texts"));
  EXPECT_THAT(ComplaintOf("\"id\": 4", "\"id\": 2"),
              HasSubstr("a.json:experiences[1].id: is 2; ids ascend"));
  EXPECT_THAT(ComplaintOf("\"id\": 10", "\"id\": 13"),
              HasSubstr("a.json:experiences[4].id: is 13; ids ascend from 1 to "
                        "last_experience, 12"));
  EXPECT_THAT(ComplaintOf("\"last_experience\": 12", "\"last_experience\": -1"),
              HasSubstr("a.json.last_experience: should be a whole number from "
                        "0 on"));
  EXPECT_THAT(ComplaintOf("\"id\": 4", "\"id\": 4e999"),
              HasSubstr("a.json: is not JSON: a number in it is too large"));
  EXPECT_THAT(ComplaintOf("\"id\": 4", "\"id\": 9223372036854775808"),
              HasSubstr("a.json:experiences[1].id: should be a whole number"));
}

TEST(ExperienceJson, AnAtomThatIsNoneIsNamed) {
  for (const char* text :
       {"Clear", "Clear(", "(a)", "Clear(a", "Clear(a)b", "Clear(a,b)",
        "Clear(a, )", "Clear(, a)", "??Clear(a)", "Clear((a))", ""}) {
    EXPECT_THAT(ComplaintOf("Clear(separator)", text),
                HasSubstr("a.json:experiences[0].before[0]: should be a "
                          "predicate of objects"))
        << text;
  }
}

}  // namespace
}  // namespace cell
