#include "services/cell/running/service_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>

namespace cell::cli {
namespace {

constexpr char kProperties[] =
    "Id,ActiveState,SubState,NRestarts,MainPID,CPUUsageNSec,MemoryCurrent,"
    "StateChangeTimestamp";

// What systemd does not count it writes as "[not set]" or 2^64 - 1.
int64_t NumberIn(const std::map<std::string, std::string>& block,
                 const std::string& key) {
  const auto it = block.find(key);
  const bool is_number =
      it != block.end() && !it->second.empty() && it->second.size() < 19 &&
      it->second.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? std::stoll(it->second) : 0;
}

ServiceUnit UnitOf(const std::map<std::string, std::string>& block) {
  const auto text = [&](const char* key) {
    const auto it = block.find(key);
    return it == block.end() ? std::string() : it->second;
  };
  ServiceUnit unit;
  unit.name = text("Id");
  unit.state = fmt::format("{} ({})", text("ActiveState"), text("SubState"));
  unit.is_active = text("ActiveState") == "active";
  unit.is_failed = text("ActiveState") == "failed";
  unit.num_restarts = NumberIn(block, "NRestarts");
  unit.pid = NumberIn(block, "MainPID");
  unit.processor_s =
      1e-9 * static_cast<double>(NumberIn(block, "CPUUsageNSec"));
  unit.memory_bytes = NumberIn(block, "MemoryCurrent");
  unit.since = text("StateChangeTimestamp");
  return unit;
}

}  // namespace

std::vector<ServiceUnit> ParseUnits(const std::string& text) {
  std::vector<ServiceUnit> units;
  std::map<std::string, std::string> block;
  const auto end_block = [&] {
    if (block.contains("Id")) units.push_back(UnitOf(block));
    block.clear();
  };
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const size_t equals = line.find('=');
    if (equals == std::string::npos) {
      end_block();
    } else {
      block[line.substr(0, equals)] = line.substr(equals + 1);
    }
  }
  end_block();
  std::sort(units.begin(), units.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return units;
}

void ServiceManager::Start() const {
  Run("start cell.target");
}

void ServiceManager::Stop() const {
  Run("stop cell.target 'cell-*.service'");
}

std::vector<ServiceUnit> ServiceManager::Units() const {
  return ParseUnits(
      Run(fmt::format("show 'cell-*.service' --property={}", kProperties)));
}

std::string ServiceManager::Run(const std::string& arguments) const {
  const std::string command =
      fmt::format("systemctl {}{} 2>&1", is_user_ ? "--user " : "", arguments);
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string output;
  std::array<char, 4096> buffer;
  while (const size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.append(buffer.data(), size);
  }
  if (pclose(pipe) == 0) return output;
  const char* help =
      output.find("not found") != std::string::npos
          ? "the cell is not installed: cmake --install build/release"
      : is_user_
          ? "is a systemd --user manager running (loginctl)?"
          : "it takes root: sudo cell ...; or a cell of your own: --user";
  throw std::runtime_error(
      fmt::format("systemctl {}: {}{}", arguments, output, help));
}

}  // namespace cell::cli
