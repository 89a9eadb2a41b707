// The command line as users run it: processes, LCM on a private network, logs.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "common/bus/event_log.h"
#include "common/bus/run_log.h"
#include "common/imaging/png_file.h"
#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

class CellCommand : public RunCell {};

TEST_F(CellCommand,
       TheSameSeedGivesTheSameBytesOverLcmBusyOrNotAndInOneProcess) {
  // A person shows something, then the arms work.
  const std::string episodes = " --seed 7 --demonstration two_pegs+execution ";
  const std::string idle = Hash("demo" + episodes + "--out a");
  // Two busy loops beside it, which end by themselves.
  const std::string busy =
      Shell("cd " + dir_.string() +
            "; for i in 1 2; do timeout 600 sh -c 'while :; do :; done' "
            "> /dev/null 2>&1 & pids=\"$pids $!\"; done; " +
            kCell + " demo" + episodes +
            "--hash --out b 2> /dev/null; kill $pids 2> /dev/null")
          .output;
  const std::string sim = Hash("sim" + episodes + "--out c");
  EXPECT_EQ(idle, sim);
  EXPECT_EQ(busy, sim);
  std::set<std::string> channels;
  std::istringstream lines(sim);
  std::string channel;
  std::string digest;
  while (lines >> channel >> digest) {
    EXPECT_THAT(channel, testing::MatchesRegex("[A-Z0-9_]+"));
    EXPECT_THAT(digest, testing::MatchesRegex("[0-9a-f]+"));
    channels.insert(channel);
  }
  EXPECT_GE(channels.size(), 8u);
  const ShellResult diff = Cell("diff a c");
  EXPECT_EQ(diff.code, 0) << diff.output;
  EXPECT_NE(Hash("sim --seed 8 --demonstration two_pegs --out d"), sim);
  const ShellResult other = Cell("diff a d");
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.output, HasSubstr("tick "));
}

TEST_F(CellCommand, KilledServicesComeBackAsTheyDoInOneProcess) {
  std::string kills;
  int tick = 400;
  for (int moment = 0; moment < 3; ++moment) {
    for (const char* service : {"tracker", "sec_builder", "recognizer",
                                "predicate_estimator", "planner", "library"}) {
      kills += " --kill " + std::string(service) + "@" + std::to_string(tick);
      tick += 211;
    }
  }
  const std::string lcm =
      Hash("demo --seed 7 --demonstration assembly --out a" + kills);
  size_t num_deaths = 0;
  const RunLog log = RunLog::Load(dir_ / "a");
  EXPECT_THAT(log.problems(), testing::IsEmpty());
  for (const auto& [k, entry] : log.ticks()) {
    for (const joined_t& joined : entry.manifest.joined) {
      num_deaths += joined.death_tick >= 0;
    }
  }
  EXPECT_EQ(num_deaths, 18u);
  EXPECT_EQ(
      lcm, Hash("sim --seed 7 --demonstration assembly --out b --deaths-of a"));
  const ShellResult replay = Cell("replay a --check");
  EXPECT_EQ(replay.code, 0) << replay.output;
}

TEST_F(CellCommand, ARunThatCannotBeginLeavesNoFolder) {
  const ShellResult run = Cell("sim --demonstration nowhere --out a");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("nowhere"));
  EXPECT_FALSE(fs::exists(dir_ / "a"));
}

TEST_F(CellCommand, ADemoOnAFullDiskEndsAndSaysSo) {
  std::ofstream(dir_ / "run.sh")
      << "mkdir small; mount -t tmpfs -o size=700k none small\n"
      << kCell << " demo --seed 7 --demonstration two_pegs --out small/a\n";
  const ShellResult run =
      Shell("cd " + dir_.string() + " && " + InPrivateNetwork() +
            WithPrivateMounts() + "bash run.sh");
  EXPECT_EQ(run.code, 1) << run.output;
  EXPECT_THAT(run.output, AnyOf(HasSubstr("No space left on device"),
                                HasSubstr("the disk is full")));
  size_t num_restarts = 0;
  for (size_t at = 0;
       (at = run.output.find("restarted", at)) != std::string::npos;) {
    ++at;
    ++num_restarts;
  }
  EXPECT_LE(num_restarts, 2u) << run.output;
}

TEST_F(CellCommand, AKilledRecorderGoesOnInANewFileAndNamesWhatItMisses) {
  const ShellResult run = Cell(
      "demo --seed 7 --demonstration two_pegs --out a --kill recorder@500");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("recorder: killed by signal 9, restarted"));
  EXPECT_THAT(run.output, HasSubstr("the log lacks ticks "));
  EXPECT_TRUE(fs::exists(dir_ / "a" / "cell-0002.lcmlog"));
  const RunLog log = RunLog::Load(dir_ / "a");
  ASSERT_EQ(log.problems().size(), 1u);
  EXPECT_THAT(log.problems()[0], HasSubstr("are missing"));
}

TEST_F(CellCommand, ReplayRecomputesEveryServiceAndFindsAPlantedDifference) {
  ASSERT_EQ(Cell("sim --seed 3 --demonstration two_pegs --out a").code, 0);
  const ShellResult good = Cell("replay a --check");
  EXPECT_EQ(good.code, 0) << good.output;
  for (const char* service : {"vtb", "tracker", "sec_builder", "recognizer",
                              "predicate_estimator", "planner", "recorder"}) {
    EXPECT_THAT(good.output, HasSubstr(service));
  }
  // Another episode's first tick that differs is named with its channel.
  const std::string yaml = TextOf(dir_ / "a" / "run.yaml");
  std::string other = yaml;
  other.replace(other.find("seed: 3"), 7, "seed: 4");
  std::ofstream(dir_ / "a" / "run.yaml") << other;
  const ShellResult bad = Cell("replay a --check --service vtb");
  EXPECT_EQ(bad.code, 1);
  EXPECT_THAT(bad.output, HasSubstr("DIFFERENT: tick "));
}

TEST_F(CellCommand, ReplayNamesADamagedMessage) {
  ASSERT_EQ(Cell("sim --seed 3 --demonstration two_pegs --out a").code, 0);
  const fs::path path = dir_ / "a" / "cell-0001.lcmlog";
  std::vector<LogEvent> events;
  {
    EventLogReader reader(path);
    while (auto event = reader.Next()) events.push_back(std::move(*event));
  }
  EventLogWriter writer(path);
  bool is_planted = false;
  for (LogEvent& event : events) {
    if (event.channel == "ACTION" && !is_planted) {
      event.bytes.back() ^= 1;
      is_planted = true;
    }
    writer.Write(event.utime, event.channel, event.bytes);
  }
  writer.Flush();
  ASSERT_TRUE(is_planted);
  const ShellResult bad = Cell("replay a --check");
  EXPECT_EQ(bad.code, 1);
  EXPECT_THAT(bad.output, HasSubstr("ACTION"));
}

TEST_F(CellCommand, ATruncatedLogIsReadToTheCut) {
  ASSERT_EQ(Cell("sim --seed 3 --demonstration two_pegs --out a").code, 0);
  const fs::path path = dir_ / "a" / "cell-0001.lcmlog";
  fs::resize_file(path, fs::file_size(path) * 2 / 3);
  const ShellResult replay = Cell("replay a");
  EXPECT_EQ(replay.code, 1);
  EXPECT_THAT(replay.output, HasSubstr("are damaged"));
  EXPECT_THAT(replay.output, HasSubstr("recognised "));
}

TEST_F(CellCommand, ThePersonsAssemblyIsRecognisedAndTheArmsMakeAnother) {
  const ShellResult run = Cell("demo --seed 1 --out a");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("recognised 9 of 9 steps"));
  EXPECT_THAT(run.output, HasSubstr("the goal is reached"));
  EXPECT_THAT(run.output,
              HasSubstr("assembled 8 of 8 placements, screwed 1 of 1"));
  const std::regex least(R"(least visible: \w+, (\d+) pix)");
  std::string rest = run.output;
  for (const char* picture : {"episode-1.png", "episode-2.png"}) {
    EXPECT_GT(fs::file_size(dir_ / "a" / picture), 10'000u);
    std::smatch match;
    ASSERT_TRUE(std::regex_search(rest, match, least));
    EXPECT_GE(std::stoi(match[1]), 50) << "a part is hidden in " << picture;
    rest = match.suffix();
  }
  EXPECT_THAT(Cell("chain a --object hed").output,
              HasSubstr("did you mean 'head'? Known: base,"));
  // Every service, the arms' among them, recomputes its outputs.
  const ShellResult replay = Cell("replay a --check");
  EXPECT_EQ(replay.code, 0) << replay.output;
}

TEST_F(CellCommand, EvalGoesOnWhereItWasCut) {
  const ShellResult first =
      Cell("eval watch --runs 1 --seed 900 --rows r --json m.json");
  EXPECT_EQ(first.code, 0) << first.output;
  const std::string rows = TextOf(dir_ / "r");
  // Cut within the last row: that one is run again, the others are kept.
  std::ofstream(dir_ / "r") << rows.substr(0, rows.size() - 20);
  const ShellResult second =
      Cell("eval watch --runs 1 --seed 900 --rows r --resume");
  EXPECT_EQ(second.code, 0) << second.output;
  EXPECT_EQ(first.output, second.output);
  for (const char* key : {"measure", "value", "low", "high", "paper", "goal",
                          "met", "runs", "seed"}) {
    EXPECT_THAT(TextOf(dir_ / "m.json"),
                HasSubstr("\"" + std::string(key) + "\""));
  }
}

/// The first word of each line below "Subcommands:" that begins an entry.
std::vector<std::string> SubcommandsIn(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(
      help.substr(std::min(help.find("Subcommands:"), help.size())));
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < 3 || !line.starts_with("  ") || line[2] == ' ') continue;
    names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

TEST_F(CellCommand, EveryCommandShowsAnExample) {
  std::vector<std::string> commands = {""};
  for (size_t i = 0; i < commands.size(); ++i) {
    const ShellResult help = Cell(commands[i] + " --help");
    EXPECT_EQ(help.code, 0) << commands[i];
    EXPECT_THAT(help.output, HasSubstr("Example: ")) << commands[i];
    for (const std::string& name : SubcommandsIn(help.output)) {
      commands.push_back(commands[i] + " " + name);
    }
  }
  EXPECT_GT(commands.size(), 80);
  for (const char* service :
       {"vtb", "tracker", "sec_builder", "recognizer", "predicate_estimator",
        "planner", "robot_arm", "supervisor", "recorder", "library",
        "motion_planner", "camera_set"}) {
    const ShellResult help =
        Shell(std::string(CELL_BIN_DIR) + "/" + service + " --help");
    EXPECT_EQ(help.code, 0) << service;
    EXPECT_THAT(help.output, HasSubstr("Example: ")) << service;
  }
}

TEST_F(CellCommand, MistakesAreUsageErrorsThatSayWhatIsWrong) {
  EXPECT_EQ(Cell("dance").code, 2);
  EXPECT_THAT(Cell("replay nowhere").output, HasSubstr("nowhere"));
  EXPECT_THAT(Cell("demo --kill vtb@9 --out x").output, HasSubstr("--kill"));
  EXPECT_THAT(Cell("sim --demonstration nothing --out y").output,
              HasSubstr("nothing"));
  fs::create_directories(dir_ / "full" / "file");
  EXPECT_THAT(Cell("sim --out full").output, HasSubstr("not empty"));
}

TEST_F(CellCommand, AloneListsItsCommandsAndHasAVersion) {
  const ShellResult alone = Cell("");
  EXPECT_EQ(alone.code, 0);
  EXPECT_THAT(alone.output, HasSubstr("Subcommands:"));
  EXPECT_THAT(Cell("--version").output, testing::StartsWith("cell "));
}

TEST_F(CellCommand, AMistypedNameIsAnsweredWithTheNearestAndTheList) {
  const std::pair<const char*, const char*> slips[] = {
      {"evel", "did you mean 'eval'? Known: demo, sim,"},
      {"eval wach", "did you mean 'watch'? Known: watch, alarms,"},
      {"library lst", "did you mean 'list'?"},
      {"sim --demonstration assembli",
       "did you mean 'assembly'? Known: assembly,"}};
  for (const auto& [arguments, answer] : slips) {
    const ShellResult run = Cell(arguments);
    EXPECT_NE(run.code, 0) << arguments;
    EXPECT_THAT(run.output, HasSubstr(answer)) << arguments;
  }
  const ShellResult list = Cell("list");
  EXPECT_EQ(list.code, 0);
  for (const char* name : {"cranfield", "assembled", "take_backs", "execution",
                           "recognizer", "ScrewHead", "disturbed"}) {
    EXPECT_THAT(list.output, HasSubstr(name));
  }
}

TEST_F(CellCommand, AStoppedRunSaysWhereItsLogIs) {
  for (const char* command :
       {"sim --out run", "eval watch --runs 50 --rows rows"}) {
    const ShellResult stopped =
        Shell("cd " + dir_.string() + " && timeout -s INT --foreground 3 " +
              kCell + " " + command);
    EXPECT_THAT(stopped.output, testing::ContainsRegex("stopped; .*(run|rows)"))
        << command;
  }
  EXPECT_THAT(Cell("replay run").output, HasSubstr("episode 1"));
}

TEST_F(CellCommand, AMisspeltKeyIsNamedWithItsFile) {
  fs::copy(fs::path(CELL_SOURCE_DIR) / "deploy", dir_ / "deploy",
           fs::copy_options::recursive);
  std::ofstream(dir_ / "deploy" / "config" / "tracker.yaml", std::ios::app)
      << "\nperiod_tikcs: 3\n";
  const ShellResult run = Cell("sim --deploy deploy --out a");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("tracker.yaml:period_tikcs"));
}

TEST_F(CellCommand, WithoutAMulticastRouteAServiceSaysWhatToDo) {
  const ShellResult run = Shell(InPrivateNetwork() + CELL_BIN_DIR + "/planner");
  EXPECT_EQ(run.code, 1) << run.output;
  EXPECT_THAT(run.output, HasSubstr("ip route add 224.0.0.0/4 dev lo"));
}

// Services started by hand on a private network, and an operator who sends an
// invalid command, then ends the episode.
TEST_F(CellCommand, AnOperatorIsAnsweredByARunningCell) {
  const std::string bin = CELL_BIN_DIR;
  std::ofstream(dir_ / "run.sh")
      << "ip link set lo up && ip route add 224.0.0.0/4 dev lo\n"
         "for s in tracker sec_builder recognizer predicate_estimator planner "
         "supervisor recorder library motion_planner 'robot_arm --instance "
         "left' "
         "'robot_arm --instance right'; do "
      << bin << "/$s --run-dir . & done\n"
      << bin << "/vtb --pace realtime --giveup 60 & clock=$!\n"
      << "ask() { " << bin
      << "/cell $* --deadline 60 >>answers.txt 2>&1; "
         "echo exit code $? >>answers.txt; }\n"
         "for try in 1 2 3 4 5 6 7 8 9 10; do "
      << bin
      << "/cell hold --deadline 60 && break; done\n"
         "ask resume\n"
         "ask goal nonsense\n"
         "ask episode start --demonstration nonsense\n"
         "ask episode end\n"
         "wait $clock\n";
  const ShellResult run = Shell("cd " + dir_.string() + " && " +
                                InPrivateNetwork() + "bash run.sh");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("hold accepted: the arms stop"));
  const std::string answers = TextOf(dir_ / "answers.txt");
  EXPECT_THAT(
      answers,
      testing::ContainsRegex(
          "resume accepted: .*\nexit code 0\n"
          "goal nonsense refused: .* no goal 'nonsense'.*\nexit code 1\n"
          "episode start refused: .* no demonstration 'nonsense'.*\n"
          "exit code 1\n"
          "episode end accepted: episode 1 .*\nexit code 0\n"));
  const RunLog log = RunLog::Load(dir_);
  int num_commands = 0;
  for (const auto& [k, tick] : log.ticks()) {
    for (const Message& message : tick.messages) {
      num_commands += message.channel == "COMMAND_EPISODE";
    }
  }
  EXPECT_EQ(num_commands, 2);
  EXPECT_LT(log.ticks().size(), 5000u) << "the episode went on";
}

// Every indented line of the README that calls the built program.
TEST_F(CellCommand, TheReadmesCommandsRun) {
  std::istringstream readme(TextOf(fs::path(CELL_SOURCE_DIR) / "README.md"));
  const std::string prefix = "    build/release/bin/cell ";
  std::string line;
  int num_run = 0;
  while (std::getline(readme, line)) {
    if (!line.starts_with(prefix)) continue;
    const std::string arguments = line.substr(prefix.size());
    const ShellResult run = Cell(arguments.substr(0, arguments.find('#')));
    const bool is_diff = arguments.starts_with("diff");
    EXPECT_EQ(run.code, is_diff ? 1 : 0) << line << "\n" << run.output;
    ++num_run;
  }
  EXPECT_GE(num_run, 6);

  // The README's own picture, by the id of every pixel.
  ASSERT_EQ(Cell("view runs/sim-0003 --ids --out ids.png").code, 0);
  const RgbImage fresh = ReadColourPng(dir_ / "ids.png");
  const RgbImage shown =
      ReadColourPng(fs::path(CELL_SOURCE_DIR) / "docs/assembled_ids.png");
  ASSERT_EQ(fresh.pixels.size(), shown.pixels.size());
  size_t num_different = 0;
  for (size_t i = 0; i < fresh.pixels.size(); ++i) {
    num_different += fresh.pixels[i] != shown.pixels[i];
  }
  EXPECT_LE(num_different, fresh.pixels.size() / 100)
      << "draw docs/assembled.png and docs/assembled_ids.png again, by `cell "
         "view` as in the README, with --ids for the second";
}

}  // namespace
}  // namespace cell
