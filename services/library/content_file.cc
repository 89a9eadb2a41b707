#include "services/library/content_file.h"

#include <fstream>
#include <sstream>

#include "common/files/draft.h"
#include "services/library/action_store.h"
#include "services/library/record_json.h"

namespace cell::library {

void WriteContent(const std::filesystem::path& file,
                  const std::vector<ActionRecord>& records) {
  WriteFile(file, TextOfContent(records));
}

void ExportContent(const std::filesystem::path& file,
                   const std::vector<ActionRecord>& records) {
  WriteNewFile(file, TextOfContent(records),
               "choose another file or remove it");
}

std::vector<ActionRecord> ReadContent(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  if (!stream || !(text << stream.rdbuf())) {
    throw StoreError(file.string() + ": cannot be read");
  }
  try {
    return ContentFromText(text.str(), file.string());
  } catch (const std::invalid_argument& e) {
    throw StoreError(e.what());
  }
}

}  // namespace cell::library
