#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace cell::cli {

/// The rows of an evaluation, one JSON object a line, appended as they come, so
/// that a cut evaluation can go on. Storage adapter.
class RowStore {
 public:
  /// With `is_resumed`, keeps the rows that are there (a cut last line is
  /// dropped); else begins anew. @throws std::runtime_error naming the file.
  RowStore(std::filesystem::path path, bool is_resumed);

  void Append(const std::string& key, const nlohmann::json& row);
  bool Has(const std::string& key) const { return rows_.contains(key); }
  const nlohmann::json& At(const std::string& key) const {
    return rows_.at(key);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::map<std::string, nlohmann::json> rows_;
};

}  // namespace cell::cli
