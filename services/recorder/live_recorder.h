#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "services/recorder/rotating_log.h"

namespace cell::recorder {

/// Every channel of a live cell -> logs in the run folder, as they come: the
/// services' journals (STEP) say the order. ALERT when the disk is full and
/// when there is room again.
class LiveRecorder : public Service {
 public:
  LiveRecorder(Bus& bus, const std::filesystem::path& run_dir,
               const RotatingLog::Params& params);

 private:
  void OnTick();
  void Publish(int8_t level, const std::string& text);

  Bus& bus_;
  RotatingLog log_;
  std::vector<Message> messages_;  // of this activation
  int64_t num_missed_ = 0;         // since the disk is full
  int32_t retry_tick_ = 0;
};

}  // namespace cell::recorder
