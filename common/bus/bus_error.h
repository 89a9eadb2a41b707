#pragma once

#include <stdexcept>
#include <string>

namespace cell {

/// The bus cannot go on: what() names channel, sender and tick, and what to do.
class BusError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cell
