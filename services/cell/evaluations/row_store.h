#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "services/cell/evaluations/row_identity.h"
#include "services/cell/evaluations/row_shape.h"

namespace cell::cli {

/// The rows of an evaluation, one JSON object a line, appended as they come, so
/// that an interrupted evaluation can go on. The first line says what they are
/// of. While it exists, no other process writes to the file. Storage adapter.
class RowStore {
 public:
  /// What a file of rows is for.
  struct Params {
    std::filesystem::path path;
    bool is_resumed = false;
    RowIdentity identity;
    RowShape shape;  ///< of a row; its readers need no more than that
  };
  /// If it is resumed, keeps the rows that are there (a cut last line is
  /// dropped). @throws std::runtime_error naming the file, and leaves it as it
  /// is: if it holds rows and is not resumed, if its rows are of anything else
  /// than `identity` or not of the shape, if it holds anything else, or if
  /// another evaluation writes to it.
  explicit RowStore(Params params);
  RowStore(const RowStore&) = delete;
  RowStore& operator=(const RowStore&) = delete;
  ~RowStore();

  /// @throws std::runtime_error if the row has another shape, or cannot be
  /// written
  void Append(const std::string& key, const nlohmann::json& row);
  bool Has(const std::string& key) const { return rows_.contains(key); }
  const nlohmann::json& At(const std::string& key) const {
    return rows_.at(key).row;
  }
  /// Those that are there, in the order of the keys.
  std::vector<nlohmann::json> RowsOf(
      const std::vector<std::string>& keys) const;
  /// @throws std::runtime_error "FILE: line 7: row 'KEY': WHAT", and how to go
  /// on. @pre Has(key)
  [[noreturn]] void FailAt(const std::string& key,
                           const std::string& what) const;
  const std::filesystem::path& path() const { return params_.path; }

 private:
  struct Entry {
    nlohmann::json row;
    int line = 0;
  };
  [[noreturn]] void Fail(const std::string& what) const;
  void Load();
  std::string Header() const { return ToJson(params_.identity).dump(); }
  void CheckHeader(const std::optional<nlohmann::json>& header) const;
  void Write(const std::string& text);

  Params params_;
  int file_ = -1;
  int num_lines_ = 0;
  std::map<std::string, Entry> rows_;
};

}  // namespace cell::cli
