#include "common/files/temporary_folder.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <fstream>
#include <stdexcept>

#include "tests/test_folder.h"

namespace cell {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsNewAndGoneWithAllThatIsInIt) {
  fs::path first, second;
  {
    const TemporaryFolder a("test"), b("test");
    first = a.path();
    second = b.path();
    EXPECT_NE(first, second);
    EXPECT_TRUE(fs::is_empty(first));
    std::ofstream(first / "file") << "text";
  }
  EXPECT_FALSE(fs::exists(first));
  EXPECT_FALSE(fs::exists(second));
}

TEST(TemporaryFolder, SaysThatThereIsNoPlaceForIt) {
  const fs::path folder = NewTestFolder();
  setenv("TMPDIR", folder.c_str(), 1);
  fs::remove_all(folder);
  try {
    const TemporaryFolder none("test");
    ADD_FAILURE() << none.path();
  } catch (const std::exception& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("TMPDIR"));
  }
  unsetenv("TMPDIR");
}

}  // namespace
}  // namespace cell
