#include "services/cell/running/cell_address.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "common/bus/message.h"
#include "common/bus/private_network.h"
#include "common/node/number_option.h"
#include "common/text/printable.h"
#include "services/cell/running/demo_registry.h"

namespace cell::cli {
namespace {

/// A cell publishes every 8 ms of its time, which may take longer while it
/// computes.
constexpr int kMaxWaitMs = 500;

bool IsCellHeard(const LcmAddress& address) {
  LcmPort port(address.MainUrl());
  bool is_heard = false;
  port.Subscribe(".*", [&](const std::string& channel, Bytes bytes) {
    is_heard |= MessageFromWire(channel, std::move(bytes)) != nullptr;
  });
  constexpr int kStepMs = 10;
  for (int waited = 0; !is_heard && waited < kMaxWaitMs; waited += kStepMs) {
    WaitForAny({&port}, kStepMs);
    port.Drain();
  }
  return is_heard;
}

std::string ListOf(const std::vector<RunningDemo>& demos) {
  std::vector<std::string> texts;
  for (const RunningDemo& demo : demos) {
    texts.push_back(fmt::format("--demo {} ({})", demo.pid, demo.run.string()));
  }
  return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ", "));
}

void Join(const RunningDemo& demo) {
  JoinNetworkOf(demo.pid);
  std::cerr << Printable(fmt::format("in the network of `cell demo` {}, {}",
                                     demo.pid, demo.run.string()))
            << std::endl;
}

}  // namespace

void CellAddress::AddTo(CLI::App& app) {
  address_.AddTo(app);
  url_option_ = app.get_option("--url");
  app.add_option(
         "--demo", demo_,
         "process id of one of your `cell demo` runs, each of which has its "
         "own network (default: the only one, if no other cell is heard)")
      ->check(NumberIn(1))
      ->excludes(url_option_);
}

LcmAddress CellAddress::Reach() const {
  const LcmAddress address = address_.Get();
  if (url_option_->count() > 0) return address;
  const std::vector<RunningDemo> demos = FindRunningDemos();
  if (demo_ > 0) {
    const auto it = std::ranges::find(demos, demo_, &RunningDemo::pid);
    if (it == demos.end()) {
      throw std::invalid_argument(
          fmt::format("--demo {}: none of your `cell demo` runs has this "
                      "process id. Running: {}",
                      demo_, ListOf(demos)));
    }
    Join(*it);
    return address;
  }
  if (demos.empty() || IsCellHeard(address)) return address;
  if (demos.size() > 1) {
    throw std::invalid_argument(
        "no cell is heard on this network, and several of your demos are "
        "running; choose one: " +
        ListOf(demos));
  }
  Join(demos.front());
  return address;
}

}  // namespace cell::cli
