// The source text of the cell, for tests that read it.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace cell {

/// The text of each file, by its name.
using Sources = std::map<std::string, std::string>;

inline std::string WithoutCommentsAndTexts(const std::string& text) {
  static const std::regex kPassedOver(
      R"re(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/|#[^\n]*)re"
      R"re(|R"(\w*)\([\s\S]*?\)\2"|"(\\.|[^"\\\n])*"|'(\\.|[^'\\\n])')re");
  return std::regex_replace(text, kPassedOver, "");
}

/// Of headers, sources and message types below the folders.
inline Sources SourcesBelow(const std::vector<std::string>& folders) {
  namespace fs = std::filesystem;
  const fs::path root = CELL_SOURCE_DIR;
  Sources sources;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".h" && extension != ".cc" && extension != ".lcm") {
        continue;
      }
      std::ifstream file(entry.path());
      std::stringstream text;
      // A type of a message is a class of the namespace that its package is.
      if (extension == ".lcm") text << "namespace cell {\n";
      text << file.rdbuf();
      if (extension == ".lcm") text << "}\n";
      const auto name = entry.path().lexically_relative(root).string();
      sources[name] =
          extension == ".lcm"
              ? std::regex_replace(text.str(), std::regex("package [^;]*;"), "")
              : text.str();
    }
  }
  return sources;
}

}  // namespace cell
