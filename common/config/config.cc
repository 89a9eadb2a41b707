#include "common/config/config.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace cell {

Config::Config(YAML::Node node, std::string path,
               std::shared_ptr<Shared> shared)
    : node_(std::move(node)),
      path_(std::move(path)),
      shared_(std::move(shared)) {}

Config Config::Load(const std::string& path) {
  auto shared = std::make_shared<Shared>();
  shared->file = path;
  try {
    return Config(YAML::LoadFile(path), "", shared);
  } catch (const YAML::BadFile&) {
    throw ConfigError(path + ": cannot be opened");
  } catch (const YAML::Exception& e) {
    throw ConfigError(
        fmt::format("{}:{}: not YAML: {}", path, e.mark.line + 1, e.msg));
  }
}

Config Config::Parse(const std::string& text, const std::string& name) {
  auto shared = std::make_shared<Shared>();
  shared->file = name;
  try {
    return Config(YAML::Load(text), "", shared);
  } catch (const YAML::Exception& e) {
    throw ConfigError(
        fmt::format("{}:{}: not YAML: {}", name, e.mark.line + 1, e.msg));
  }
}

Config Config::operator[](const std::string& key) const {
  MarkUsed();
  const std::string path = path_.empty() ? key : path_ + "." + key;
  if (!node_.IsMap()) Fail("should be a map with the key '" + key + "'");
  const YAML::Node child = node_[key];
  Config config(child.IsDefined() ? child : YAML::Node(), path, shared_);
  if (!child.IsDefined()) config.Fail("missing");
  config.MarkUsed();
  return config;
}

bool Config::Has(const std::string& key) const {
  return node_.IsMap() && node_[key].IsDefined();
}

std::vector<Config> Config::Items() const {
  MarkUsed();
  if (!node_.IsSequence()) Fail("should be a list");
  std::vector<Config> items;
  for (size_t i = 0; i < node_.size(); ++i) {
    items.push_back(Config(node_[i], fmt::format("{}[{}]", path_, i), shared_));
    items.back().MarkUsed();
  }
  return items;
}

std::vector<std::pair<std::string, Config>> Config::Entries() const {
  MarkUsed();
  if (!node_.IsMap()) Fail("should be a map");
  std::vector<std::pair<std::string, Config>> entries;
  for (const auto& entry : node_) {
    const auto key = entry.first.as<std::string>();
    entries.emplace_back(key, (*this)[key]);
  }
  return entries;
}

std::vector<Config> Config::ItemsOf(const std::string& key) const {
  return Has(key) ? (*this)[key].Items() : std::vector<Config>{};
}

std::vector<double> Config::Numbers(const std::string& key, size_t size) const {
  const Config config = (*this)[key];
  auto numbers = config.As<std::vector<double>>();
  if (numbers.size() != size) {
    config.Fail(fmt::format("needs {} numbers, has {}", size, numbers.size()));
  }
  for (const double number : numbers) {
    if (!std::isfinite(number)) config.Fail("has a number that is not finite");
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
  FinishNode(node_, path_);
}

void Config::FinishNode(const YAML::Node& node, const std::string& path) const {
  if (!path.empty() && !shared_->used.contains(path)) {
    throw ConfigError(shared_->file + ":" + path +
                      ": not known; remove it or mend its spelling");
  }
  if (node.IsMap()) {
    for (const auto& entry : node) {
      const auto key = entry.first.as<std::string>();
      FinishNode(entry.second, path.empty() ? key : path + "." + key);
    }
  } else if (node.IsSequence()) {
    // A list of numbers, or of such lists, is read as a whole.
    for (size_t i = 0; i < node.size(); ++i) {
      const std::string item = fmt::format("{}[{}]", path, i);
      if (node[i].IsMap() || shared_->used.contains(item)) {
        FinishNode(node[i], item);
      }
    }
  }
}

void Config::Fail(const std::string& message) const {
  throw ConfigError(shared_->file + ":" + path_ + ": " + message);
}

std::string Config::Text() const {
  MarkUsed();
  return YAML::Dump(node_);
}

const std::string& Config::file() const {
  return shared_->file;
}

void Config::MarkUsed() const {
  shared_->used.insert(path_);
}

std::string Config::Shown() const {
  return node_.IsScalar() ? ": '" + node_.Scalar() + "'" : "";
}

}  // namespace cell
