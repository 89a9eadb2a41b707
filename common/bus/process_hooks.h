#pragma once

#include <functional>

namespace cell {

/// Notifications for the parent of a process. They do not depend on messages of
/// the bus: a service is alive, too, while its clock stands still.
struct ProcessHooks {
  std::function<void()> on_ready = [] {
  };  ///< once it listens
  std::function<void()> on_alive = [] {
  };  ///< again and again
};

}  // namespace cell
