#include "services/library/content_file.h"

#include <fstream>
#include <sstream>

#include "common/files/draft.h"
#include "services/library/action_store.h"
#include "services/library/content_json.h"

namespace cell::library {

void WriteContent(const std::filesystem::path& file,
                  const LibraryContent& content) {
  WriteFile(file, TextOfContent(content));
}

void ExportContent(const std::filesystem::path& file,
                   const LibraryContent& content) {
  WriteNewFile(file, TextOfContent(content),
               "choose another file or remove it");
}

LibraryContent ReadContent(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) {
    throw StoreError(file.string() + ": cannot be read");
  }
  std::stringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof())
    text << stream.rdbuf();
  try {
    return ContentFromText(text.str(), file.string());
  } catch (const std::invalid_argument& e) {
    throw StoreError(e.what());
  }
}

}  // namespace cell::library
