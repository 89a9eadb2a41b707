#pragma once

#include "common/node/address_option.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cell::cli {

/// The address of the cell that a command is for: --url if that is given; the
/// network of `cell demo` number --demo if that is given; else this network if
/// a cell is heard there, or else the only demo of this user.
class CellAddress {
 public:
  /// Adds --url, --allow-network and --demo. This must outlive the parsing.
  void AddTo(CLI::App& app);

  /// Before the process starts threads: it may move into a demo's network, and
  /// then reports it on standard error. @throws std::invalid_argument that
  /// names the option, or the demos among which one has to choose.
  LcmAddress Reach() const;

 private:
  AddressOption address_;
  int demo_ = 0;  // process id
  CLI::Option* url_option_ = nullptr;
};

}  // namespace cell::cli
