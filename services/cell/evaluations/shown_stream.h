#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/config/deployment.h"
#include "common/recordings/recording.h"
#include "common/scene/relation_layers.h"
#include "common/sec/sec_library.h"
#include "common/task/task.h"
#include "services/recognizer/recognition.h"

namespace cell::cli {

/// Demonstrations that are shown to the cores of sec_builder and recognizer as
/// one stream that is not segmented.
struct ShownStreamParams {
  struct Demonstration {
    std::string name;
    std::function<Recording()> load;
  };
  std::vector<Demonstration> demonstrations;
  double noise_mm = 0;  ///< of the poses; the estimator knows it
  uint64_t seed = 1;    ///< of the noise
  std::shared_ptr<const SecLibrary> library;
  bool has_layers = false;  ///< key frames are enriched by all layers
};

/// What happened in the stream, and what was recognised.
struct ShownStream {
  struct Done {
    std::string demonstration;     ///< its name
    int64_t begin_utime = 0;       ///< [us] of the demonstration
    Recording::TrueAction action;  ///< in the time of the stream
  };
  std::vector<Done> done;                                ///< by utime
  std::vector<recognizer::RecognisedAction> recognised;  ///< as they came
  std::vector<RelationLayers> layers;  ///< of each key frame, if it has them
};

/// @param observe  called with each manipulation, unless empty
/// @throws RecordingError for a file that is no recording of the task.
ShownStream ShowStream(const ShownStreamParams& params,
                       const Deployment& deployment, const Task& task,
                       const std::function<void(const std::string&)>& show,
                       recognizer::Recognition::Observer observe = {});

}  // namespace cell::cli
