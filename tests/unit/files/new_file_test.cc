#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include "common/files/draft.h"
#include "tests/test_folder.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

std::string ErrorOf(const std::function<void()>& check) {
  try {
    check();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

std::string ErrorAt(const fs::path& path) {
  return ErrorOf([&] { RequireFree(path, "choose another"); });
}

class NewFile : public testing::Test {
 protected:
  NewFile() { std::ofstream(dir_ / "file") << "text"; }

  const fs::path dir_ = NewTestFolder();
};

TEST_F(NewFile, NeverReplacesAFile) {
  EXPECT_THAT(ErrorAt(dir_ / "file"),
              HasSubstr("file: exists; choose another"));
}

TEST_F(NewFile, IsRefusedAtOnceWhereNoneCanBe) {
  EXPECT_THAT(ErrorAt(dir_), HasSubstr("cannot be written: Is a directory"));
  EXPECT_THAT(ErrorAt(dir_ / "file" / "x"),
              HasSubstr("file: cannot be made: Not a directory"));
  EXPECT_THAT(ErrorAt("/proc/x"), HasSubstr("/proc/x: cannot be written"));
}

TEST_F(NewFile, ItsFolderIsMadeAndNothingElse) {
  EXPECT_THAT(ErrorAt(dir_ / "a" / "b" / "x"), IsEmpty());
  EXPECT_TRUE(fs::is_empty(dir_ / "a" / "b"));
  WriteNewFile(dir_ / "c" / "x", "text", "");
  EXPECT_EQ(fs::file_size(dir_ / "c" / "x"), 4U);
}

TEST_F(NewFile, MayBeADevice) {
  EXPECT_THAT(ErrorAt("/dev/null"), IsEmpty());
}

TEST_F(NewFile, IsNotNamedTwice) {
  fs::create_directory_symlink(dir_, dir_ / "link");
  EXPECT_THAT(ErrorOf([] { RequireDistinct({"x", "", "y", ""}); }), IsEmpty());
  EXPECT_THAT(ErrorOf([] {
                RequireDistinct({"x", "", "./x"});
              }),
              HasSubstr("./x: would be written twice"));
  EXPECT_THAT(ErrorOf([&] {
                RequireDistinct({dir_ / "x", dir_ / "link" / "x"});
              }),
              HasSubstr("x: would be written twice"));
}

}  // namespace
}  // namespace cell
