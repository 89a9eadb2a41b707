#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace cell::cli {

/// What the rows of a file are of: everything that changes a row but what its
/// key says. How many runs are asked for, and in how many processes, does not.
struct RowIdentity {
  std::string command;                         ///< "eval rexd"
  std::map<std::string, std::string> options;  ///< "sure" by "--teacher"
  std::map<std::string, std::string> files;    ///< digests of texts, by name

  /// @param name  what people know the file by, wherever it lies
  void AddFile(const std::string& name, const std::string& text);
};

/// As the first line of a file of rows.
nlohmann::json ToJson(const RowIdentity& identity);
/// True if a line is one that ToJson() made.
bool IsRowIdentity(const nlohmann::json& line);

/// In what an earlier call, whose first line this is, differs; empty: in
/// nothing. "--teacher was noisy, now it is sure".
/// @pre IsRowIdentity(line)
std::string DifferenceFrom(const nlohmann::json& line,
                           const RowIdentity& identity);

}  // namespace cell::cli
