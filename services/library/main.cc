// library: keeps the actions that the cell knows.
#include <CLI/CLI.hpp>

#include "common/node/run_service.h"
#include "services/library/library.h"
#include "services/library/open_store.h"

int main(int argc, char** argv) {
  std::string database;
  return cell::RunService(
      "library", argc, argv,
      [&](cell::Bus& bus, const cell::Deployment& deployment) {
        return cell::library::MakeLibrary(
            bus, deployment, cell::library::OpenStore(deployment, database));
      },
      [&](CLI::App& app) {
        app.add_option("--database", database,
                       "file that keeps the actions (default: library.db in "
                       "the run folder; without one, memory)");
      });
}
