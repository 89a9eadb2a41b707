#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace cell::cli {

/// What main() runs once the arguments are parsed; its exit code.
using Action = std::function<int()>;

/// Of a file that --out names and that is there already.
inline constexpr char kAnotherOut[] = "choose another --out or remove it";

/// Adds every command to the command line, in the order of its help.
void AddAllCommands(CLI::App& app, Action* action);

/// @throws CLI::ParseError with the nearest command and all of them if the
/// arguments begin with a command, or a command's subcommand, that is not
/// there; CLI::CallForHelp if there are no arguments.
void CheckCommandNames(CLI::App& app, int argc, const char* const* argv);

// Each adds one subcommand to the command line and, if it is chosen, sets
// `action`. One file per command; hold and resume share one, and up, down and
// status.
void AddDemo(CLI::App& app, Action* action);
void AddSim(CLI::App& app, Action* action);
void AddReplay(CLI::App& app, Action* action);
void AddDiff(CLI::App& app, Action* action);
void AddEval(CLI::App& app, Action* action);
void AddView(CLI::App& app, Action* action);
void AddCheck(CLI::App& app, Action* action);
void AddChain(CLI::App& app, Action* action);
void AddEpisode(CLI::App& app, Action* action);
void AddHold(CLI::App& app, Action* action);
void AddResume(CLI::App& app, Action* action);
void AddConfirm(CLI::App& app, Action* action);
void AddGoal(CLI::App& app, Action* action);
void AddPrepare(CLI::App& app, Action* action);
void AddUp(CLI::App& app, Action* action);
void AddDown(CLI::App& app, Action* action);
void AddStatus(CLI::App& app, Action* action);
void AddTop(CLI::App& app, Action* action);
void AddRecord(CLI::App& app, Action* action);
void AddLog(CLI::App& app, Action* action);
void AddSpy(CLI::App& app, Action* action);
void AddDoctor(CLI::App& app, Action* action);
void AddExplain(CLI::App& app, Action* action);
void AddSec(CLI::App& app, Action* action);
void AddTypes(CLI::App& app, Action* action);
void AddLearn(CLI::App& app, Action* action);
void AddLibrary(CLI::App& app, Action* action);
void AddName(CLI::App& app, Action* action);
void AddRules(CLI::App& app, Action* action);
void AddList(CLI::App& app, Action* action);
void AddPlan(CLI::App& app, Action* action);
void AddMonitor(CLI::App& app, Action* action);

// The evaluations that need no cell: subcommands of eval.
void AddEvalRules(CLI::App& eval, Action* action);
void AddEvalGrowth(CLI::App& eval, Action* action);
void AddEvalRexd(CLI::App& eval, Action* action);
void AddEvalExcuses(CLI::App& eval, Action* action);
void AddEvalMistakes(CLI::App& eval, Action* action);

}  // namespace cell::cli
