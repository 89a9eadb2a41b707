#pragma once

#include <memory>
#include <span>
#include <string>

#include "common/bus/bus.h"
#include "common/config/deployment.h"
#include "services/recorder/canonical_order.h"
#include "services/recorder/log_store.h"

namespace cell::recorder {

/// Every channel -> a canonical log in the run folder, at any speed. After a
/// death the next incarnation reports on ALERT which ticks the logs lack.
class Recorder : public Service {
 public:
  Recorder(Bus& bus, const std::filesystem::path& run_dir);

 private:
  void OnMessage(const std::string& channel, std::span<const uint8_t> bytes);
  void OnTick(const Message& message);
  void ReportGap(int32_t from, int32_t to);

  Bus& bus_;
  CanonicalOrder order_;
  LogStore store_;
  bool is_first_tick_ = true;
  int32_t complete_before_ = 0;  // tick
};

std::unique_ptr<Service> MakeRecorder(Bus& bus, const Deployment& deployment);

}  // namespace cell::recorder
