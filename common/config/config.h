#pragma once

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace cell {

/// A configuration that cannot be used; what() begins with file:key.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One node of a YAML file, read strictly: a missing key and a value of the
/// wrong type throw at once, keys that nobody read throw in Finish(). Every
/// error names file and key, e.g. "tracker.yaml:period_ticks: missing".
class Config {
 public:
  /// @throws ConfigError if the file cannot be read or is not YAML.
  static Config Load(const std::string& path);
  /// `name` stands for the file in errors.
  static Config Parse(const std::string& text, const std::string& name);

  /// The map entry `key`. @throws ConfigError if missing or not a map.
  Config operator[](const std::string& key) const;
  bool Has(const std::string& key) const;
  /// Elements of a list, or [] of a missing optional key's stand-in.
  std::vector<Config> Items() const;
  /// Entries of a map in file order.
  std::vector<std::pair<std::string, Config>> Entries() const;
  /// Items() of `key`, none if it is missing.
  std::vector<Config> ItemsOf(const std::string& key) const;

  template <class T>
  T As() const {
    MarkUsed();
    // yaml-cpp reads an empty value as the text "null".
    if (node_.IsNull()) Fail("is empty, should be " + TypeName<T>());
    try {
      T value = node_.as<T>();
      if constexpr (std::is_floating_point_v<T>) {
        if (!std::isfinite(value)) Fail("is not a finite number" + Shown());
      }
      return value;
    } catch (const YAML::Exception&) {
      Fail("cannot be read as " + TypeName<T>() + Shown());
    }
  }
  template <class T>
  T Get(const std::string& key) const {
    return (*this)[key].As<T>();
  }
  template <class T>
  T GetOr(const std::string& key, T fallback) const {
    return Has(key) ? Get<T>(key) : fallback;
  }
  /// A list of exactly `size` numbers.
  std::vector<double> Numbers(const std::string& key, size_t size) const;
  /// @throws ConfigError unless low <= value <= high.
  double Number(const std::string& key, double low, double high) const;
  int Integer(const std::string& key, int low, int high) const;

  /// @throws ConfigError for keys of this node, and of all below it, that were
  /// never read: misspelt or not known.
  void Finish() const;

  /// @throws ConfigError "file:key: message".
  [[noreturn]] void Fail(const std::string& message) const;
  /// The node as YAML that stands for itself.
  std::string Text() const;
  const std::string& path() const { return path_; }
  const std::string& file() const;

 private:
  struct Shared {
    std::string file;
    std::set<std::string> used;
  };
  Config(YAML::Node node, std::string path, std::shared_ptr<Shared> shared);
  void MarkUsed() const;
  void FinishNode(const YAML::Node& node, const std::string& path) const;
  std::string Shown() const;
  template <class T>
  static std::string TypeName() {
    if constexpr (std::is_same_v<T, bool>) return "true or false";
    if constexpr (std::is_integral_v<T>) return "a whole number";
    if constexpr (std::is_floating_point_v<T>) return "a number";
    if constexpr (std::is_same_v<T, std::string>) return "text";
    return "the list it should be";
  }

  YAML::Node node_;
  std::string path_;
  std::shared_ptr<Shared> shared_;
};

}  // namespace cell
