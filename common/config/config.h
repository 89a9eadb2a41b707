#pragma once

#include <yaml-cpp/yaml.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/config/decimal.h"
#include "common/config/strict_yaml.h"

namespace cell {

/// One node of a YAML file, read strictly (LoadStrictYaml): a missing key and a
/// value of the wrong type throw at once, keys that were not read throw in
/// Finish(). Numbers are decimal (ParseDecimal), booleans true or false. Every
/// error names file, key and line, e.g. "tracker.yaml:period_ticks: missing
/// (line 3)".
class Config {
 public:
  /// @throws ConfigError if the file cannot be read or is not YAML.
  static Config Load(const std::string& path);
  /// `name` replaces the file in errors. `has_lines`: false for generated text,
  /// in which line numbers mean nothing.
  static Config Parse(const std::string& text, const std::string& name,
                      bool has_lines = true);

  /// The map entry `key`. @throws ConfigError if missing or not a map.
  Config operator[](const std::string& key) const;
  bool Has(const std::string& key) const;
  /// Elements of a list, or [] of a missing optional key's stand-in.
  std::vector<Config> Items() const;
  /// Entries of a map in file order.
  std::vector<std::pair<std::string, Config>> Entries() const;
  /// Items() of `key`, none if it is missing.
  std::vector<Config> ItemsOf(const std::string& key) const;

  /// Of a number, bool, string, or a list of them.
  template <class T>
  T As() const {
    T value{};
    Read(&value);
    return value;
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

  /// @throws ConfigError "file:key: message (line 3)".
  [[noreturn]] void Fail(const std::string& message) const;
  const std::string& path() const { return path_; }
  const std::string& file() const;

 private:
  struct Shared {
    std::string file;
    std::set<std::string> used;
    bool has_lines = true;
  };
  Config(YAML::Node node, std::string path, int line,
         std::shared_ptr<Shared> shared);
  void MarkUsed() const;
  void FinishNode(const YAML::Node& node, const std::string& path,
                  int line) const;
  [[noreturn]] void FailAt(const std::string& path, int line,
                           const std::string& message) const;
  std::string PathOf(const std::string& key) const;

  /// The text of a value that should be `what`.
  const std::string& Scalar(const char* what) const;
  template <class T>
  void ReadNumber(const char* what, T* value) const;
  void Read(bool* value) const;
  void Read(int* value) const;
  void Read(uint64_t* value) const;
  void Read(double* value) const;
  void Read(std::string* value) const;
  template <class T>
  void Read(std::vector<T>* values) const {
    for (const Config& item : Items()) values->push_back(item.As<T>());
  }

  YAML::Node node_;
  std::string path_;
  int line_;  // from 1; 0: none
  std::shared_ptr<Shared> shared_;
};

}  // namespace cell
