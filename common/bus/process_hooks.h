#pragma once

#include <functional>

namespace cell {

/// What whoever has started a process wants to be told. Depends on nothing that
/// the bus carries: a service whose clock stands still is alive.
struct ProcessHooks {
  std::function<void()> on_ready = [] {
  };  ///< once it listens
  std::function<void()> on_alive = [] {
  };  ///< again and again
};

}  // namespace cell
