#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/rules/data_text.h"
#include "common/rules/rule_text.h"

namespace cell::rules {

inline std::shared_ptr<const SymbolTable> SymbolsFrom(const std::string& text) {
  return std::make_shared<const SymbolTable>(SymbolTable::Parse(text, "s"));
}

inline ExperienceSet ExperiencesFrom(const std::string& symbols,
                                     const std::string& data) {
  return ParseExperiences(data, "d", SymbolsFrom(symbols));
}

/// One word for each character.
inline std::vector<std::string> ObjectsFrom(const std::string& letters) {
  std::vector<std::string> objects;
  for (const char letter : letters) objects.emplace_back(1, letter);
  return objects;
}

}  // namespace cell::rules
