#include <CLI/CLI.hpp>

#include "services/cell/commands/commands.h"
#include "services/cell/commands/sec_commands.h"

namespace cell::cli {

void AddSec(CLI::App& app, Action* action) {
  CLI::App* sec = app.add_subcommand(
      "sec",
      "Work with semantic event chains and the demonstrations they come "
      "from.\n"
      "Example: cell sec record runs/sim-0001 --out demonstration.recording");
  sec->require_subcommand(1);
  AddSecImport(*sec, action);
  AddSecPlot(*sec, action);
  AddSecRecord(*sec, action);
  AddSecSimilar(*sec, action);
}

}  // namespace cell::cli
