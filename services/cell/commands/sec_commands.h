#pragma once

#include "services/cell/commands/commands.h"

namespace cell::cli {

inline constexpr char kChooseAnotherOut[] = "choose another --out or remove it";

// Each adds one subcommand to `cell sec` and, if it is chosen, sets `action`.
// One file per subcommand: sec_<name>.cc.
void AddSecImport(CLI::App& sec, Action* action);
void AddSecPlot(CLI::App& sec, Action* action);
void AddSecRecord(CLI::App& sec, Action* action);
void AddSecSimilar(CLI::App& sec, Action* action);

}  // namespace cell::cli
