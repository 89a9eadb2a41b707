#pragma once

#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>

namespace cell {

/// A configuration that cannot be used; what() begins with file:key.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "file:key: message (line 3)"; without a key or a line (from 1) they are
/// left out.
std::string ConfigMessage(const std::string& file, const std::string& key,
                          int line, const std::string& message);

/// Reads the one document of a file, and refuses what YAML allows but is a
/// mistake in a configuration, where yaml-cpp would silently do something else:
/// a key twice, keys that are no plain words, tags, merge keys, a second
/// document, an anchor's name twice, an alias within what it stands for, or of
/// more nodes than memory holds, a literal that a comma cuts in two, tabs that
/// indent, what is no UTF-8, a quote without an end, an empty file.
/// @throws ConfigError.
YAML::Node LoadStrictYaml(const std::string& text, const std::string& file);

}  // namespace cell
