#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/system/shell.h"
#include "tests/test_folder.h"

namespace cell {

/// Tests of the command line: each has a folder of its own, in which commands
/// run, and which stays if the test fails.
class RunCell : public testing::Test {
 protected:
  static inline const std::string kCell = std::string(CELL_BIN_DIR) + "/cell";

  void SetUp() override {
    dir_ = NewTestFolder();
    // The demos of other tests are not this one's.
    setenv("XDG_RUNTIME_DIR", (dir_ / "runtime").c_str(), 1);
  }
  void TearDown() override {
    if (!HasFailure()) std::filesystem::remove_all(dir_);
  }
  ShellResult Cell(const std::string& arguments) const {
    return Shell("cd " + dir_.string() + " && " + kCell + " " + arguments);
  }
  /// Lines of digests alone; what else was said goes to stderr.
  std::string Hash(const std::string& arguments) const {
    const std::string log = (dir_ / "stderr").string();
    const ShellResult result =
        Shell("(cd " + dir_.string() + " && " + kCell + " " + arguments +
              " --hash 2>" + log + ")");
    EXPECT_EQ(result.code, 0) << result.output << TextOf(log);
    return result.output;
  }
  static std::string TextOf(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  std::filesystem::path dir_;
};

}  // namespace cell
