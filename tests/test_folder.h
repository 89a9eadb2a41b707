#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace cell {

/// Makes an empty folder that only the running test uses: ctest runs the tests
/// of a fixture at the same time, each in a process of its own.
inline std::filesystem::path NewTestFolder() {
  const auto& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test.test_suite_name()) + "-" + test.name();
  std::ranges::replace(name, '/', '-');
  const auto folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace cell
