#include <CLI/CLI.hpp>

#include "services/cell/commands/commands.h"
#include "services/cell/commands/sec_commands.h"

namespace cell::cli {

void AddSec(CLI::App& app, Action* action) {
  CLI::App* sec = app.add_subcommand(
      "sec",
      "Work with semantic event chains.\n"
      "Example: cell sec import pour_01.csv pour_02.csv stir_01.csv");
  sec->require_subcommand(1);
  AddSecImport(*sec, action);
}

}  // namespace cell::cli
