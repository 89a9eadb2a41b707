#include "services/cell/evaluations/row_store.h"

#include <fstream>
#include <stdexcept>
#include <utility>

namespace cell::cli {

RowStore::RowStore(std::filesystem::path path, bool is_resumed)
    : path_(std::move(path)) {
  if (path_.has_parent_path()) {
    std::filesystem::create_directories(path_.parent_path());
  }
  if (is_resumed) {
    std::ifstream file(path_);
    std::string line;
    while (std::getline(file, line)) {
      const auto row = nlohmann::json::parse(line, nullptr, false);
      if (row.is_object() && row.contains("key") && row["key"].is_string())
        rows_[row["key"]] = row;
    }
  }
  const std::filesystem::path fresh = path_.string() + ".new";
  std::ofstream file(fresh, std::ios::trunc);
  for (const auto& [key, row] : rows_) file << row.dump() << "\n";
  if (!file.flush()) {
    throw std::runtime_error(fresh.string() + ": cannot be written");
  }
  std::filesystem::rename(fresh, path_);
}

void RowStore::Append(const std::string& key, const nlohmann::json& row) {
  nlohmann::json keyed = row;
  keyed["key"] = key;
  std::ofstream file(path_, std::ios::app);
  file << keyed.dump() << "\n";
  if (!file.flush()) {
    throw std::runtime_error(path_.string() + ": cannot be written");
  }
  rows_[key] = std::move(keyed);
}

}  // namespace cell::cli
