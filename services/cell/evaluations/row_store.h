#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace cell::cli {

/// The rows of an evaluation, one JSON object a line, appended as they come, so
/// that an interrupted evaluation can go on. While it exists, no other process
/// writes to the file. Storage adapter.
class RowStore {
 public:
  /// With `is_resumed`, keeps the rows that are there (a cut last line is
  /// dropped). @throws std::runtime_error naming the file, and leaves it as it
  /// is: if it holds rows and is not resumed, if it holds anything else, or if
  /// another evaluation writes to it.
  RowStore(std::filesystem::path path, bool is_resumed);
  RowStore(const RowStore&) = delete;
  RowStore& operator=(const RowStore&) = delete;
  ~RowStore();

  void Append(const std::string& key, const nlohmann::json& row);
  bool Has(const std::string& key) const { return rows_.contains(key); }
  const nlohmann::json& At(const std::string& key) const {
    return rows_.at(key);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void Fail(const std::string& what) const;
  void Load();
  void Write(const std::string& text);

  std::filesystem::path path_;
  int file_ = -1;
  std::map<std::string, nlohmann::json> rows_;
};

}  // namespace cell::cli
