#include "services/library/content_file.h"

#include <fstream>
#include <sstream>

#include "services/library/action_store.h"
#include "services/library/record_json.h"

namespace cell {

void WriteContent(const std::filesystem::path& file,
                  const std::vector<ActionRecord>& records) {
  std::filesystem::path draft = file;
  draft += ".new";
  {
    std::ofstream stream(draft);
    stream << TextOfContent(records);
    if (!stream.flush()) {
      throw StoreError(draft.string() +
                       ": cannot be written; is the folder there, may this "
                       "user write to it, has the disk room?");
    }
  }
  std::filesystem::rename(draft, file);
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

}  // namespace cell
