#include "services/cell/commands/commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <string_view>

#include "common/text/nearest.h"
#include "common/text/printable.h"

namespace cell::cli {
void AddAllCommands(CLI::App& app, Action* action) {
  app.set_version_flag("--version", "cell " CELL_VERSION);
  for (const auto add :
       {AddDemo,    AddSim,     AddList,    AddReplay,  AddDiff,  AddEval,
        AddView,    AddChain,   AddExplain, AddCheck,   AddUp,    AddDown,
        AddStatus,  AddTop,     AddDoctor,  AddEpisode, AddHold,  AddResume,
        AddGoal,    AddConfirm, AddPrepare, AddLibrary, AddRules, AddPlan,
        AddMonitor, AddRecord,  AddLog,     AddSpy,     AddTypes, AddSec,
        AddLearn,   AddName}) {
    add(app, action);
  }
}

void CheckCommandNames(CLI::App& app, int argc, const char* const* argv) {
  if (argc <= 1) throw CLI::CallForHelp();
  CLI::App* level = &app;
  for (int i = 1; i < argc; ++i) {
    const auto commands = level->get_subcommands({});
    const std::string_view word = argv[i];
    if (commands.empty() || word.starts_with('-')) return;
    const auto name_of = [](const CLI::App* a) {
      return a->get_name();
    };
    const auto it = std::ranges::find(commands, word, name_of);
    if (it == commands.end()) {
      throw CLI::ParseError("there is no command '" + Printable(word) + "'" +
                                NamesInstead(word, NamesIn(commands, name_of)),
                            CLI::ExitCodes::ExtrasError);
    }
    level = *it;
  }
}

}  // namespace cell::cli
