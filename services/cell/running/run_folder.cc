#include "services/cell/running/run_folder.h"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "common/actions/sec_models.h"
#include "common/files/draft.h"
#include "common/recordings/recording_file.h"
#include "common/task/learned_rules.h"
#include "services/library/open_store.h"
#include "services/library/sqlite_action_store.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

Deployment DeploymentIn(const fs::path& run, const std::string& task) {
  return {.config_dir = run / "deploy" / "config",
          .task_dir = run / "deploy" / "tasks" / task,
          .types_dir = run / "lcmtypes",
          .run_dir = run};
}

/// The folder of recorded frames that play if it lies outside the task's, of
/// which a run has a copy anyway; else empty.
/// @throws ConfigError if it is not there.
fs::path FramesElsewhere(const Deployment& source) {
  const fs::path file = source.config_dir / "camera_set.yaml";
  if (!fs::exists(file)) return {};
  const Config config = Config::Load(file);
  if (config.Get<std::string>("device") != "recorded") return {};
  const Config folder = config["recorded"]["folder"];
  const fs::path named = folder.As<std::string>();
  const fs::path path = source.task_dir / named;
  if (!fs::is_directory(path)) {
    folder.Fail("there is no folder " + path.string());
  }
  const fs::path normal = named.lexically_normal();
  const bool is_of_task = normal.is_relative() && *normal.begin() != "..";
  return is_of_task ? fs::path() : path;
}

void ChangeYaml(const fs::path& file,
                const std::function<void(YAML::Node)>& change) {
  const YAML::Node node = YAML::LoadFile(file.string());
  change(node);
  WriteFile(file, YAML::Dump(node) + "\n");
}

/// Copies them into the copy of the task's folder, where the copy of the
/// configuration finds them then.
void KeepFrames(const fs::path& frames, const Deployment& deployment) {
  std::string name = "recorded";
  while (fs::exists(deployment.task_dir / name)) name += "_frames";
  fs::copy(frames, deployment.task_dir / name, fs::copy_options::recursive);
  ChangeYaml(deployment.config_dir / "camera_set.yaml",
             [&](YAML::Node config) { config["recorded"]["folder"] = name; });
}

// Several processes may want a folder at once: the first to create an entry in
// it owns it.
void Claim(const fs::path& run) {
  MakeFolder(run);
  if (!fs::is_empty(run) || !fs::create_directory(run / "deploy")) {
    throw std::runtime_error(run.string() +
                             ": exists and is not empty; choose another --out");
  }
}

/// Leaves the actions of the task's domain that have rules by hand, and takes
/// away what was learned of the others.
void ForgetActions(YAML::Node domain) {
  std::vector<std::string> unknown;
  for (const auto& entry : domain["actions"]) {
    if (!entry.second["rules"])
      unknown.push_back(entry.first.as<std::string>());
  }
  for (const std::string& name : unknown) {
    domain["actions"].remove(name);
    if (domain["requests"] && domain["requests"]["do"]) {
      domain["requests"]["do"].remove(name);
    }
  }
  domain.remove(kLearnedRulesKey);
}

}  // namespace

fs::path ClaimRunFolder(const fs::path& runs, const std::string& kind) {
  MakeFolder(runs);
  for (int number = 1;; ++number) {
    fs::path path = runs / fmt::format("{}-{:04}", kind, number);
    if (fs::create_directory(path)) return path;
  }
}

void PointTo(const fs::path& run, const fs::path& link) {
  const fs::path next = run.string() + ".link";  // no other run has this name
  fs::remove(next);
  fs::create_symlink(run.filename(), next);
  fs::rename(next, link);
}

RunFolder RunFolder::Create(const std::string& path, const std::string& kind,
                            const Deployment& source,
                            const std::string& demonstration, uint64_t seed) {
  RunFolder run;
  run.path = path.empty() ? ClaimRunFolder("runs", kind) : fs::path(path);
  Claim(run.path);
  try {
    run.Fill(source);
    run.AskFor(demonstration, seed);
  } catch (...) {
    run.Discard();
    throw;
  }
  return run;
}

void RunFolder::Fill(const Deployment& source) {
  const fs::path frames = FramesElsewhere(source);
  const std::string task = source.task_dir.filename().string();
  deployment = DeploymentIn(path, task);
  constexpr auto kDeep = fs::copy_options::recursive;
  fs::copy(source.config_dir, deployment.config_dir, kDeep);
  fs::create_directories(deployment.task_dir);
  for (const auto& entry : fs::directory_iterator(source.task_dir)) {
    const fs::path name = entry.path().filename();
    if (name == kRecordingsFolder) continue;  // a run does not need them
    fs::copy(entry.path(), deployment.task_dir / name, kDeep);
  }
  if (!frames.empty()) KeepFrames(frames, deployment);
  if (fs::is_directory(source.types_dir)) {
    fs::create_directories(deployment.types_dir);
    for (const auto& entry : fs::directory_iterator(source.types_dir)) {
      if (entry.path().extension() == ".lcm") {
        fs::copy(entry.path(), deployment.types_dir);
      }
    }
  }
  roster =
      Roster::FromConfig(Config::Load(deployment.config_dir / "roster.yaml"));
}

void RunFolder::AskFor(const std::string& episodes, uint64_t chance) {
  demonstration = episodes;
  seed = chance;
  WriteFile(
      path / "run.yaml",
      fmt::format("task: {}\ndemonstration: \"{}\"\nseed: {}\n"
                  "library: {{file: \"{}\", change: {}, build: \"{}\"}}\n",
                  deployment.task_dir.filename().string(), demonstration, seed,
                  library.file, library.change, library.build));
}

void RunFolder::EnableServices(const std::string& option) {
  const fs::path file = deployment.config_dir / "roster.yaml";
  roster = Roster::FromConfig(Config::Load(file.string()), option);
  ChangeYaml(file, [&](YAML::Node node) {
    for (YAML::Node entry : node["services"]) {
      if (entry["option"] && entry["option"].as<std::string>() == option) {
        entry.remove("option");
      }
    }
  });
}

void RunFolder::LeaveToPerson(const std::vector<std::string>& actions) const {
  ChangeYaml(deployment.config_dir / "planner.yaml", [&](YAML::Node planner) {
    planner["execution"]["help_steps"] = actions;
  });
}

void RunFolder::SetLearning(bool is_learning) const {
  for (const char* service : {"recognizer.yaml", "planner.yaml"}) {
    ChangeYaml(deployment.config_dir / service,
               [&](YAML::Node config) { config["learning"] = is_learning; });
  }
}

void RunFolder::DoWithoutConfirmation() const {
  ChangeYaml(deployment.config_dir / "planner.yaml", [](YAML::Node planner) {
    planner["exploration"]["confirmation"] = false;
  });
}

void RunFolder::UseLibrary(const fs::path& file) {
  const fs::path target = fs::absolute(file).lexically_normal();
  {
    const library::SqliteActionStore store(
        target, library::SqliteActionStore::Mode::kCreate);
    const auto changes = store.Changes();
    this->library = {target.string(), 0, ""};
    if (!changes.empty()) {
      this->library.change = changes.back().number;
      this->library.build = changes.back().build;
    }
  }
  fs::create_symlink(target, path / library::kDatabaseName);
  AskFor(demonstration, seed);
}

void RunFolder::ForgetEventChains() const {
  ChangeYaml(deployment.config_dir / "recognizer.yaml",
             [](YAML::Node recognizer) { recognizer["learning"] = true; });
  WriteFile(deployment.task_dir / kSecModelsFile, "models: {}\n");
}

void RunFolder::LearnFromNothing() const {
  SetLearning(true);
  DoWithoutConfirmation();
  ForgetEventChains();
  ChangeYaml(deployment.task_dir / "domain.yaml", ForgetActions);
}

void RunFolder::Stopped() const {
  throw std::runtime_error("stopped; the log is in " + path.string() +
                           " (print it with cell replay)");
}

void RunFolder::Discard() const {
  fs::remove_all(path);
}

RunFolder RunFolder::Open(const std::string& path) {
  RunFolder run;
  run.path = path;
  if (!fs::is_directory(run.path)) {
    throw std::runtime_error(path + ": is not a run folder");
  }
  const Config config = Config::Load(run.path / "run.yaml");
  run.deployment = DeploymentIn(run.path, config.Get<std::string>("task"));
  run.deployment.run_dir.clear();  // reading must not write
  run.deployment.repeated_dir = run.path;
  run.demonstration = config.Get<std::string>("demonstration");
  run.seed = config.Get<uint64_t>("seed");
  if (config.Has("library")) {  // a build before 0.1.0's changes names none
    const Config library = config["library"];
    run.library = {library.Get<std::string>("file"),
                   static_cast<int64_t>(library.Get<uint64_t>("change")),
                   library.Get<std::string>("build")};
  }
  config.Finish();
  run.roster = Roster::FromConfig(
      Config::Load(run.deployment.config_dir / "roster.yaml"));
  return run;
}

}  // namespace cell::cli
