#include "common/sec/scene_words.h"

namespace cell {

const std::string& SceneWords::PartOf(int object) const {
  const std::string& name =
      vocabulary.objects()[static_cast<size_t>(object)].name;
  const Site* site = parts.FindSite(name);
  return site ? site->host : name;
}

}  // namespace cell
