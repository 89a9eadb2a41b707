#pragma once

#include <optional>
#include <vector>

#include "common/bus/message.h"
#include "services/cell/explaining/explanation.h"

namespace cell::cli {

/// Explains one kind of thing that a cell does, from the messages of its log,
/// by computing again what a service has computed. Never from ground truth.
class Explainer {
 public:
  Explainer() = default;
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;
  virtual ~Explainer() = default;

  /// Takes the messages in canonical order.
  virtual void Put(const Message& message) = 0;
  /// Of all that has come, in its order.
  virtual const std::vector<Explanation>& explanations() const = 0;
};

/// The explanation nearest in time to `utime` [us], of equals the first.
std::optional<Explanation> NearestTo(
    int64_t utime, const std::vector<Explanation>& explanations);

}  // namespace cell::cli
