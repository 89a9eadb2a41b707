#include "services/cell/evaluations/sec_recordings.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>

#include "common/sec/chain_similarities.h"
#include "common/sec/relation_table.h"
#include "services/cell/evaluations/size_control.h"

namespace cell::cli {
namespace {

std::string TextOf(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  if (!file || !(text << file.rdbuf())) {
    throw std::runtime_error(path + ": the file cannot be read or is empty");
  }
  return text.str();
}

std::unique_ptr<ChainSimilarity> MakeMeasure(const std::string& name) {
  if (name == "size") return std::make_unique<SizeControl>();
  auto measure = MakeChainSimilarity(name);
  if (!measure) throw std::invalid_argument("no measure named " + name);
  return measure;
}

}  // namespace

std::vector<SecRecording> ReadRecordings(const std::vector<std::string>& paths,
                                         double threshold) {
  std::vector<SecRecording> recordings;
  std::set<std::filesystem::path> files;
  for (const std::string& path : paths) {
    if (!files.insert(std::filesystem::weakly_canonical(path)).second) {
      throw std::invalid_argument(path + ": is named twice");
    }
    const std::string name = std::filesystem::path(path).stem().string();
    recordings.push_back({name, name.substr(0, name.rfind('_')),
                          ChainFromTable(TextOf(path), threshold, path)});
  }
  return recordings;
}

std::vector<SecLeftOut> ClassifyLeaveOneOut(
    const std::vector<SecRecording>& recordings, const std::string& measure) {
  const auto similarity = MakeMeasure(measure);
  std::vector<SecLeftOut> results;
  for (const SecRecording& recording : recordings) {
    SecLeftOut result{"", -1, "", false};
    for (const SecRecording& other : recordings) {
      if (&other == &recording) continue;
      const double value = similarity->Between(recording.chain, other.chain);
      if (value > result.similarity) {
        result = {other.name, value, other.label, false};
      } else if (value == result.similarity && other.label != result.label) {
        result.label.clear();
      }
    }
    result.is_right = result.label == recording.label;
    results.push_back(result);
  }
  return results;
}

}  // namespace cell::cli
