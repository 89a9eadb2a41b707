#include "services/cell/commands/commands.h"

namespace cell::cli {

void AddAllCommands(CLI::App& app, Action* action) {
  for (const auto add :
       {AddDemo,    AddSim,     AddReplay, AddDiff,   AddEval,   AddView,
        AddChain,   AddCheck,   AddUp,     AddDown,   AddStatus, AddTop,
        AddDoctor,  AddEpisode, AddHold,   AddResume, AddGoal,   AddPrepare,
        AddLibrary, AddRecord,  AddLog,    AddSpy,    AddTypes}) {
    add(app, action);
  }
}

}  // namespace cell::cli
