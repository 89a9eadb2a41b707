#include "services/cell/running/service_units.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>

#include "services/cell/running/manager_failure.h"

namespace cell::cli {
namespace {

constexpr char kProperties[] =
    "Id,ActiveState,SubState,NRestarts,MainPID,CPUUsageNSec,MemoryCurrent,"
    "StateChangeTimestamp,StatusText";

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
  unit.last_words = text("StatusText");
  return unit;
}

struct CommandOutput {
  std::string text;
  int status = 0;  // as of wait()
};

CommandOutput OutputOf(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  CommandOutput output;
  std::array<char, 4096> buffer;
  while (const size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.text.append(buffer.data(), size);
  }
  output.status = pclose(pipe);
  return output;
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
  const auto [output, status] = OutputOf(
      fmt::format("systemctl {}{} 2>&1", is_user_ ? "--user " : "", arguments));
  if (status == 0) return output;
  throw std::runtime_error(
      Explain({.output = output,
               .exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 1,
               .is_user = is_user_,
               .is_root = geteuid() == 0}));
}

std::vector<std::string> ServiceManager::LastLinesOf(
    const ServiceUnit& unit) const {
  static constexpr char kCommand[] =
      "journalctl {}--unit '{}' --lines 5 --output cat --no-pager --quiet "
      "2>/dev/null";
  std::istringstream journal(
      OutputOf(fmt::format(kCommand, is_user_ ? "--user " : "", unit.name))
          .text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(journal, line);) lines.push_back(line);
  if (lines.empty() && !unit.last_words.empty()) lines = {unit.last_words};
  return lines;
}

std::string ServiceManager::JournalCommand() const {
  return fmt::format("journalctl {}-u 'cell-*'", is_user_ ? "--user " : "");
}

}  // namespace cell::cli
