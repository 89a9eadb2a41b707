#pragma once

#include <string>

#include "services/library/library_content.h"

namespace cell::library {

/// A library's content as text:
///
///   {"format": "actions of a cell", "version": 4, "build": "0.1.0",
///    "actions": [{...}, ...], "last_experience": 7, "experiences": [{...}]}
std::string TextOfContent(const LibraryContent& content);
/// @param file  begins the error
/// @throws std::invalid_argument naming file and key.
LibraryContent ContentFromText(const std::string& text,
                               const std::string& file);

}  // namespace cell::library
