#include "services/cell/running/unit_environment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "common/config/decimal.h"
#include "common/node/address_option.h"
#include "services/cell/running/task_check.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 6> kKeys = {
    "CELL_URL",     "CELL_DEMONSTRATION", "CELL_SEED",
    "CELL_NETWORK", "CELL_START",         "CELL_CAMERAS"};

fs::path UserFolder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  const fs::path config = variable("XDG_CONFIG_HOME");
  return config.empty() ? variable("HOME") / ".config" : config;
}

std::string Stripped(const std::string& text, const char* characters) {
  const size_t begin = text.find_first_not_of(characters);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(characters) + 1 - begin);
}

}  // namespace

UnitEnvironment UnitEnvironment::Load(bool is_user) {
  const fs::path file =
      (is_user ? UserFolder() / "cell" : InstalledConfigDir()) / "environment";
  std::ifstream stream(file);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  return Parse(text.str(), file.string());
}

UnitEnvironment UnitEnvironment::Parse(const std::string& text,
                                       const std::string& file) {
  UnitEnvironment environment;
  environment.file_ = file;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = Stripped(line, " \t\r");
    if (line.empty() || line[0] == '#' || line[0] == ';') continue;
    const size_t equals = line.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw ConfigError(ConfigMessage(
          file, "", number, "'" + line + "' is not of the form KEY=VALUE"));
    }
    const std::string key = Stripped(line.substr(0, equals), " \t");
    environment.entries_[key] = {Stripped(line.substr(equals + 1), " \t\"'"),
                                 number};
    const bool is_known = std::ranges::find(kKeys, key) != kKeys.end();
    if (key.starts_with("CELL_") && !is_known) {
      environment.Fail(key, fmt::format("no unit uses it; known: {}",
                                        fmt::join(kKeys, ", ")));
    }
  }
  return environment;
}

void UnitEnvironment::Check(const CellFiles& files) const {
  CheckAddress();
  RequireOneOf("CELL_NETWORK", "--allow-network");
  RequireOneOf("CELL_CAMERAS", "--cameras");
  const std::string seed = ValueOf("CELL_SEED");
  const auto number = ParseDecimal<uint64_t>(seed);
  if (!seed.empty() && !number) {
    Fail("CELL_SEED", "'" + seed + "' " + number.reason() +
                          "; should be a whole number of at least 0");
  }
  try {
    CheckTask(files, {.demonstration = ValueOf("CELL_DEMONSTRATION"),
                      .has_cameras = !ValueOf("CELL_CAMERAS").empty()});
  } catch (const std::invalid_argument& e) {
    Fail("CELL_DEMONSTRATION", e.what());
  }
}

std::string UnitEnvironment::ValueOf(const std::string& key) const {
  const auto it = entries_.find(key);
  return it == entries_.end() ? "" : it->second.value;
}

void UnitEnvironment::Fail(const std::string& key,
                           const std::string& message) const {
  throw ConfigError(ConfigMessage(file_, key, entries_.at(key).line, message));
}

void UnitEnvironment::RequireOneOf(const std::string& key,
                                   const char* flag) const {
  const std::string value = ValueOf(key);
  if (value.empty() || value == flag) return;
  Fail(key, fmt::format("is '{}', should be {} or nothing", value, flag));
}

void UnitEnvironment::CheckAddress() const {
  const std::string url = ValueOf("CELL_URL");
  if (url.empty()) return;
  AddressOption option;
  option.url = url;
  option.may_use_network = !ValueOf("CELL_NETWORK").empty();
  try {
    option.Get();
  } catch (const std::invalid_argument& e) {
    Fail("CELL_URL", e.what());
  }
}

}  // namespace cell::cli
