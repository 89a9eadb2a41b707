#pragma once

#include "services/cell/doctor/machine.h"

namespace cell::cli {

/// The machine that this process runs on. Device adapter.
class HostMachine : public Machine {
 public:
  std::optional<std::string> Read(const std::string& path) const override;
  std::vector<std::string> List(const std::string& path) const override;
  std::optional<Status> StatusOf(const std::string& path) const override;
  std::optional<std::string> LinkAt(const std::string& path) const override;
  std::optional<int64_t> FreeBytes(const std::string& path) const override;
  std::optional<std::string> Environment(
      const std::string& name) const override;
  int64_t NowSeconds() const override;
};

}  // namespace cell::cli
