#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "common/config/deployment.h"
#include "tests/test_folder.h"

namespace cell {

/// A deployment with a task folder of its own, which a test may change; gone
/// with the object.
class ChangedDeployment {
 public:
  explicit ChangedDeployment(const Deployment& original)
      : deployment_(original) {
    deployment_.task_dir = NewTestFolder();
    std::filesystem::copy(original.task_dir, deployment_.task_dir,
                          std::filesystem::copy_options::recursive);
  }
  ChangedDeployment(const ChangedDeployment&) = delete;
  ChangedDeployment& operator=(const ChangedDeployment&) = delete;
  ~ChangedDeployment() { std::filesystem::remove_all(deployment_.task_dir); }

  /// The first `from` in the file becomes `to`.
  void Change(const std::string& file, const std::string& from,
              const std::string& to) const {
    const std::filesystem::path path = deployment_.task_dir / file;
    std::stringstream stream;
    stream << std::ifstream(path).rdbuf();
    std::string text = stream.str();
    const size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("there is no " + from);
    text.replace(at, from.size(), to);
    std::ofstream(path) << text;
  }
  const Deployment& get() const { return deployment_; }

 private:
  Deployment deployment_;
};

}  // namespace cell
