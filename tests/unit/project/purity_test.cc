// What the cell promises of its source text: services and libraries are pure
// functions of their messages, and know nothing of any task.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace cell {
namespace {

namespace fs = std::filesystem;

// Sources that touch the world by trade, and why.
const std::set<std::string> kAdapters = {
    "common/config/config.cc",                 // reads YAML files
    "common/config/deployment.h",              // names them
    "common/imaging/png_file.cc",              // writes pictures
    "common/node/run_clock.cc",                // how the process ended
    "common/node/run_service.cc",              // and its signals
    "common/node/run_service.h",               // the flag that a signal sets
    "common/node/service_arguments.cc",        // what systemd names
    "common/node/service_manager.cc",          // the watchdog's time
    "common/recordings/recording_file.cc",     // reads recordings
    "common/rendering/bands.cc",               // rows on all cores
    "common/task/learned_rules.cc",            // reads learned rules
    "common/task/shipped_experiences.cc",      // and what they are learned from
    "common/text/printable_output.cc",         // what main() prints through
    "common/text/printable_output.h",          //
    "common/text/terminal.cc",                 // the screen of the person
    "services/camera_set/pcd_file.cc",         // reads recorded clouds
    "services/camera_set/pcd_header.cc",       // and their headers
    "services/camera_set/recorded_frames.cc",  // reads recorded frames
    "services/cell/commands/demo.cc",          // starts the cell's processes
    "services/cell/doctor/host_machine.cc",    // files and clock of the machine
    "services/cell/commands/eval.cc",          // writes the measures
    "services/cell/commands/plan.cc",          // reads PPDDL files
    "services/cell/commands/prepare.cc",       // when a session begins
    "services/cell/commands/rules_files.cc",   // rules and experiences
    "services/cell/commands/record.cc",        // listens until it is stopped
    "services/cell/commands/search_file.cc",   // keeps a search for a plan
    "services/cell/commands/types.cc",         // writes texts of types
    "services/cell/evaluations/job_pool.cc",   // processes of an evaluation
    "services/cell/evaluations/row_store.cc",  // rows of an evaluation
    "services/cell/evaluations/sec_recordings.cc",     // reads tables
    "services/cell/learning/experienced_episodes.cc",  // reads experiences
    "services/cell/logs/stock_reader.cc",              // runs LCM's own reader
    "services/cell/running/demo_registry.cc",          // demos that run
    "services/cell/running/process_output.cc",  // what the processes said
    "services/cell/running/process_group.cc",   // processes of a demonstration
    "services/cell/running/progress.cc",        // the wall clock for the person
    "services/cell/running/progress.h",         //
    "services/cell/running/unit_environment.cc",  // what units start with
    "services/library/content_file.cc",           // what a library held
    "services/library/library_copy.cc",           // one that cannot be written
    "services/recorder/log_store.cc",             // the log
};

std::vector<fs::path> SourcePaths() {
  std::vector<fs::path> paths;
  const fs::path top = CELL_SOURCE_DIR;
  for (const char* folder : {"common", "services"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const auto extension = entry.path().extension();
      if (extension == ".h" || extension == ".cc") {
        paths.push_back(fs::relative(entry.path(), top));
      }
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string TextOf(const fs::path& path) {
  std::ifstream file(fs::path(CELL_SOURCE_DIR) / path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool IsAdapter(const fs::path& path) {
  return path.filename() == "main.cc" ||
         path.string().starts_with("common/bus/") ||
         kAdapters.contains(path.string());
}

// Words of a text: runs of letters, split where camel case does.
std::set<std::string> WordsOf(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) words.insert(word);
    word.clear();
  };
  for (size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool is_letter = std::isalpha(c) != 0;
    const bool begins = std::isupper(c) && i > 0 &&
                        std::islower(static_cast<unsigned char>(text[i - 1]));
    if (!is_letter || begins) end_word();
    if (is_letter) word.push_back(static_cast<char>(std::tolower(c)));
  }
  end_word();
  return words;
}

TEST(Purity, CoresTouchNeitherBusClockThreadFileNorChance) {
  const std::vector<std::string> banned = {
      "#include <lcm", "lcm::",       "<chrono>",    "steady_clock",
      "system_clock",  "sleep_for",   "sleep_until", " sleep(",
      "::sleep(",      "usleep(",     "nanosleep(",  "gettimeofday",
      "clock_gettime", "std::thread", "std::async",  "std::mutex",
      "std::atomic",   "pthread_",    "<fstream>",   "ifstream",
      "ofstream",      "fopen",       "getenv",      "random_device",
      "std::rand",     "srand",       "std::cout",   "std::cerr"};
  // The command line talks to a person; that is no input of the cell.
  const auto may_print = [](const fs::path& path, const std::string& token) {
    return path.string().starts_with("services/cell/") &&
           (token == "std::cout" || token == "std::cerr");
  };
  for (const fs::path& path : SourcePaths()) {
    if (IsAdapter(path)) continue;
    const std::string text = TextOf(path);
    for (const std::string& token : banned) {
      if (may_print(path, token)) continue;
      EXPECT_EQ(text.find(token), std::string::npos)
          << path << " uses " << token;
    }
  }
}

// Tests of a fixture run at the same time: a folder that two share is gone
// while one reads it.
TEST(Purity, TestsMakeFoldersOnlyByNewTestFolder) {
  const std::vector<std::string> banned = {std::string("Temp") + "Dir(",
                                           std::string("temp_") + "directory"};
  const fs::path tests = fs::path(CELL_SOURCE_DIR) / "tests";
  int num_files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(tests)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".cc" && path.extension() != ".h") continue;
    ++num_files;
    if (path.filename() == "test_folder.h") continue;
    const std::string text = TextOf(fs::relative(path, CELL_SOURCE_DIR));
    for (const std::string& token : banned) {
      EXPECT_EQ(text.find(token), std::string::npos)
          << path << " uses " << token;
    }
  }
  EXPECT_GT(num_files, 100);
}

TEST(Purity, NoServiceAndNoLibraryKnowsATask) {
  const std::set<std::string> task_words = {
      "cranfield", "peg",   "pegs",  "plate", "plates",   "faceplate",
      "pendulum",  "shaft", "screw", "stud",  "separator"};
  for (const fs::path& path : SourcePaths()) {
    for (const std::string& word : WordsOf(TextOf(path))) {
      EXPECT_FALSE(task_words.contains(word)) << path << " says " << word;
    }
  }
}

TEST(Purity, EveryAdapterNamedHereExists) {
  for (const std::string& path : kAdapters) {
    EXPECT_TRUE(fs::exists(fs::path(CELL_SOURCE_DIR) / path)) << path;
  }
}

TEST(Purity, MainsAreTiny) {
  for (const fs::path& path : SourcePaths()) {
    if (path.filename() != "main.cc") continue;
    const std::string text = TextOf(path);
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 30) << path;
  }
}

TEST(Purity, WordsAreSplitWhereCamelCaseSplits) {
  EXPECT_THAT(
      WordsOf("RoundPeg template round_plate"),
      testing::UnorderedElementsAre("round", "peg", "template", "plate"));
}

}  // namespace
}  // namespace cell
