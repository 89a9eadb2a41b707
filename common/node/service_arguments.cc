#include "common/node/service_arguments.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <stdexcept>

namespace cell {

void ServiceArguments::AddTo(CLI::App& app) {
  address.AddTo(app);
  app.add_option("--deploy", deploy_dir, "folder with config/ and tasks/");
  app.add_option("--run-dir", run_dir, "folder in which the run is recorded");
  CLI::Option* live = app.add_flag(
      "--live", is_live,
      "run by the wall clock, as a real cell does, not in lockstep");
  app.add_option("--state-dir", state_dir,
                 "folder in which a live cell counts its services' starts "
                 "(default: $STATE_DIRECTORY)")
      ->needs(live);
}

std::filesystem::path ServiceArguments::StateDir() const {
  if (!state_dir.empty()) return state_dir;
  if (const char* of_systemd = std::getenv("STATE_DIRECTORY")) {
    return of_systemd;
  }
  throw std::invalid_argument(
      "--live counts its starts on disk: name a folder with --state-dir");
}

}  // namespace cell
