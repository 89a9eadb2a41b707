#include "services/cell/doctor/proc_table.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <set>
#include <sstream>

namespace cell::cli {
namespace {

std::optional<uint32_t> Hexadecimal(const std::string& text) {
  uint32_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, 16);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

// As /proc/net/route has it: the first number is the lowest byte.
std::optional<uint32_t> AddressAsInTable(const std::string& dotted) {
  std::istringstream in(dotted);
  uint32_t value = 0;
  for (int i = 0; i < 4; ++i) {
    uint32_t byte = 0;
    char dot = '.';
    if (!(in >> byte) || byte > 255 ||
        (i < 3 && (!(in >> dot) || dot != '.'))) {
      return std::nullopt;
    }
    value |= byte << (8 * i);
  }
  return value;
}

std::vector<std::string> WordsOf(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace

std::optional<int64_t> FirstNumber(const std::string& text) {
  int64_t value = 0;
  const auto result =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc()) return std::nullopt;
  return value;
}

std::optional<std::string> RouteTo(const std::string& address,
                                   const std::string& route_table) {
  const auto target = AddressAsInTable(address);
  if (!target) return std::nullopt;
  std::optional<std::string> device;
  int longest = -1;
  int64_t lowest_metric = 0;
  std::istringstream lines(route_table);
  for (std::string line; std::getline(lines, line);) {
    const auto words = WordsOf(line);
    if (words.size() < 8) continue;
    const auto destination = Hexadecimal(words[1]);
    const auto mask = Hexadecimal(words[7]);
    if (!destination || !mask || (*target & *mask) != *destination) continue;
    const int length = std::popcount(*mask);
    const int64_t metric = FirstNumber(words[6]).value_or(0);
    if (length > longest || (length == longest && metric < lowest_metric)) {
      device = words[0];
      longest = length;
      lowest_metric = metric;
    }
  }
  return device;
}

bool ReceivesMulticast(const std::string& device,
                       const std::string& igmp_table) {
  std::istringstream lines(igmp_table);
  for (std::string line; std::getline(lines, line);) {
    const auto words = WordsOf(line);
    if (words.size() > 1 && words[1] == device) return true;
  }
  return false;
}

std::vector<ProcessName> OwnersOfUdpPort(const Machine& machine,
                                         const std::string& root, int port) {
  std::set<std::string> links;  // "socket:[inode]"
  std::istringstream lines(machine.Read(root + "/proc/net/udp").value_or(""));
  for (std::string line; std::getline(lines, line);) {
    const auto words = WordsOf(line);
    if (words.size() < 10) continue;
    const size_t colon = words[1].find(':');
    if (colon == std::string::npos) continue;
    const auto of_line = Hexadecimal(words[1].substr(colon + 1));
    if (of_line && static_cast<int>(*of_line) == port) {
      links.insert("socket:[" + words[9] + "]");
    }
  }
  std::vector<ProcessName> owners;
  if (links.empty()) return owners;
  for (const std::string& name : machine.List(root + "/proc")) {
    const auto pid = FirstNumber(name);
    if (!pid) continue;
    const std::string folder = root + "/proc/" + name;
    const auto files = machine.List(folder + "/fd");
    const bool is_owner =
        std::any_of(files.begin(), files.end(), [&](const std::string& file) {
          const auto link = machine.LinkAt(folder + "/fd/" + file);
          return link && links.contains(*link);
        });
    if (!is_owner) continue;
    const auto words = WordsOf(machine.Read(folder + "/comm").value_or("?"));
    owners.push_back(
        {static_cast<int>(*pid), words.empty() ? "?" : words.front()});
  }
  std::sort(owners.begin(), owners.end(),
            [](const auto& a, const auto& b) { return a.pid < b.pid; });
  return owners;
}

}  // namespace cell::cli
