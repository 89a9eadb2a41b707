#include "common/node/service_arguments.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <stdexcept>

namespace cell {

void ServiceArguments::AddTo(CLI::App& app) {
  app.add_option("--url", url, "LCM address of the cell; control port: +1")
      ->capture_default_str();
  app.add_flag("--allow-network", may_use_network,
               "let a ttl above 0 in the --url reach other hosts");
  app.add_option("--deploy", deploy_dir, "folder with config/ and tasks/");
  app.add_option("--run-dir", run_dir, "folder in which the run is recorded");
  CLI::Option* live =
      app.add_flag("--live", is_live,
                   "by the wall clock, not in lockstep: as in a real cell");
  app.add_option("--state-dir", state_dir,
                 "folder in which a live cell counts its services' starts "
                 "(default: $STATE_DIRECTORY)")
      ->needs(live);
}

LcmAddress ServiceArguments::Address() const {
  const LcmAddress address = LcmAddress::Parse(url);
  if (address.ttl > 0 && !may_use_network) {
    throw std::invalid_argument(
        "--url " + url + ": with ttl=" + std::to_string(address.ttl) +
        " everyone on the network hears the cell and can speak in its name; "
        "if that is meant, say --allow-network");
  }
  return address;
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
