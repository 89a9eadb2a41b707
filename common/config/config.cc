#include "common/config/config.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace cell {

namespace {

constexpr std::uintmax_t kMaxBytes = 16 << 20;  // more is no configuration

/// From 1; of nodes that no text has, `otherwise`.
int LineOf(const YAML::Node& node, int otherwise) {
  const int line = node.Mark().line;
  return line < 0 ? otherwise : line + 1;
}

std::string TextOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ConfigError(path + ": cannot be opened");
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw ConfigError(path + ": is not a file");
  if (size > kMaxBytes) {
    throw ConfigError(fmt::format("{}: has {} bytes; more than {} are not read",
                                  path, size, kMaxBytes));
  }
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) throw ConfigError(path + ": cannot be read");
  return text.str();
}

}  // namespace

Config::Config(YAML::Node node, std::string path, int line,
               std::shared_ptr<Shared> shared)
    : node_(std::move(node)),
      path_(std::move(path)),
      line_(line),
      shared_(std::move(shared)) {}

Config Config::Load(const std::string& path) {
  return Parse(TextOf(path), path);
}

Config Config::Parse(const std::string& text, const std::string& name,
                     bool has_lines) {
  auto shared = std::make_shared<Shared>();
  shared->file = name;
  shared->has_lines = has_lines;
  return Config(LoadStrictYaml(text, name), "", 0, shared);
}

Config Config::operator[](const std::string& key) const {
  MarkUsed();
  if (!node_.IsMap()) Fail("should be a map with the key '" + key + "'");
  for (const auto& entry : node_) {
    if (entry.first.Scalar() != key) continue;
    const Config config(entry.second, PathOf(key), LineOf(entry.first, line_),
                        shared_);
    config.MarkUsed();
    return config;
  }
  FailAt(PathOf(key), LineOf(node_, line_), "missing");
}

bool Config::Has(const std::string& key) const {
  return node_.IsMap() && node_[key].IsDefined();
}

std::vector<Config> Config::Items() const {
  MarkUsed();
  if (!node_.IsSequence()) Fail("should be a list");
  std::vector<Config> items;
  for (size_t i = 0; i < node_.size(); ++i) {
    items.push_back(Config(node_[i], fmt::format("{}[{}]", path_, i),
                           LineOf(node_[i], line_), shared_));
    items.back().MarkUsed();
  }
  return items;
}

std::vector<std::pair<std::string, Config>> Config::Entries() const {
  MarkUsed();
  if (!node_.IsMap()) Fail("should be a map");
  std::vector<std::pair<std::string, Config>> entries;
  for (const auto& entry : node_) {
    const std::string& key = entry.first.Scalar();
    entries.emplace_back(key, (*this)[key]);
  }
  return entries;
}

std::vector<Config> Config::ItemsOf(const std::string& key) const {
  return Has(key) ? (*this)[key].Items() : std::vector<Config>{};
}

std::vector<double> Config::Numbers(const std::string& key, size_t size) const {
  const Config config = (*this)[key];
  const auto numbers = config.As<std::vector<double>>();
  if (numbers.size() != size) {
    config.Fail(fmt::format("needs {} numbers, has {}", size, numbers.size()));
  }
  return numbers;
}

double Config::Number(const std::string& key, double low, double high) const {
  const Config config = (*this)[key];
  const double value = config.As<double>();
  if (!(value >= low && value <= high)) {
    config.Fail(fmt::format("{} lies outside [{}, {}]", value, low, high));
  }
  return value;
}

int Config::Integer(const std::string& key, int low, int high) const {
  const Config config = (*this)[key];
  const int value = config.As<int>();
  if (value < low || value > high) {
    config.Fail(fmt::format("{} lies outside [{}, {}]", value, low, high));
  }
  return value;
}

void Config::Finish() const {
  FinishNode(node_, path_, line_);
}

void Config::FinishNode(const YAML::Node& node, const std::string& path,
                        int line) const {
  if (!path.empty() && !shared_->used.contains(path)) {
    FailAt(path, line, "not known; remove it or correct its spelling");
  }
  if (node.IsMap()) {
    for (const auto& entry : node) {
      const std::string& key = entry.first.Scalar();
      FinishNode(entry.second, path.empty() ? key : path + "." + key,
                 LineOf(entry.first, line));
    }
  } else if (node.IsSequence()) {
    // A list of numbers, or of such lists, is read as a whole.
    for (size_t i = 0; i < node.size(); ++i) {
      const std::string item = fmt::format("{}[{}]", path, i);
      if (node[i].IsMap() || shared_->used.contains(item)) {
        FinishNode(node[i], item, LineOf(node[i], line));
      }
    }
  }
}

void Config::Fail(const std::string& message) const {
  FailAt(path_, line_, message);
}

void Config::FailAt(const std::string& path, int line,
                    const std::string& message) const {
  throw ConfigError(ConfigMessage(shared_->file, path,
                                  shared_->has_lines ? line : 0, message));
}

const std::string& Config::file() const {
  return shared_->file;
}

void Config::MarkUsed() const {
  shared_->used.insert(path_);
}

std::string Config::PathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

const std::string& Config::Scalar(const char* what) const {
  MarkUsed();
  if (node_.IsNull()) Fail(fmt::format("is empty, should be {}", what));
  if (!node_.IsScalar()) Fail(fmt::format("cannot be read as {}", what));
  return node_.Scalar();
}

template <class T>
void Config::ReadNumber(const char* what, T* value) const {
  const std::string& text = Scalar(what);
  const Result<T> number = ParseDecimal<T>(text);
  if (!number) {
    Fail(fmt::format("cannot be read as {}: '{}' {}", what, text,
                     number.reason()));
  }
  *value = *number;
}

void Config::Read(int* value) const {
  ReadNumber("a whole number", value);
}

void Config::Read(uint64_t* value) const {
  ReadNumber("a whole number", value);
}

void Config::Read(double* value) const {
  ReadNumber("a number", value);
}

void Config::Read(bool* value) const {
  constexpr char kWhat[] = "true or false";
  const std::string& text = Scalar(kWhat);
  if (text != "true" && text != "false") {
    Fail(fmt::format("cannot be read as {}: '{}'", kWhat, text));
  }
  *value = text == "true";
}

void Config::Read(std::string* value) const {
  *value = Scalar("text");
}

}  // namespace cell
