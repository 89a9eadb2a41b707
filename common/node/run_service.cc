#include "common/node/run_service.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "common/bus/lcm_node.h"

namespace cell {
namespace {

std::atomic<bool> g_stop = false;
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

const std::atomic<bool>& StopOnSignals() {
  std::signal(SIGINT, [](int) { g_stop = true; });
  std::signal(SIGTERM, [](int) { g_stop = true; });
  return g_stop;
}

CellFiles FindCellFiles(const std::string& deploy_dir) {
  namespace fs = std::filesystem;
  std::vector<fs::path> candidates;
  if (!deploy_dir.empty()) {
    candidates.emplace_back(deploy_dir);
  } else {
    fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
    for (; folder != folder.root_path(); folder = folder.parent_path()) {
      candidates.push_back(folder / "deploy");
    }
  }
  for (const fs::path& candidate : candidates) {
    const fs::path config_dir = candidate / "config";
    if (!fs::is_directory(config_dir)) continue;
    const Roster roster =
        Roster::FromConfig(Config::Load(config_dir / "roster.yaml"));
    const Deployment deployment{config_dir, candidate / "tasks" / roster.task};
    if (fs::is_directory(deployment.task_dir)) return {deployment, roster};
    throw std::runtime_error((config_dir / "roster.yaml").string() +
                             ":task: there is no folder " +
                             deployment.task_dir.string());
  }
  throw std::runtime_error(
      "no deployment (a folder with config/ and tasks/) at " +
      candidates.front().string() + (deploy_dir.empty() ? " or above" : "") +
      "; name it with --deploy DIR");
}

ServiceName ServiceName::Parse(const std::string& name) {
  const size_t at = name.find('@');
  if (at == std::string::npos) return {name, ""};
  return {name.substr(0, at), name.substr(at + 1)};
}

namespace {

int Run(const std::string& program, bool has_instances, int argc, char** argv,
        const InstanceMaker& maker,
        const std::function<void(CLI::App&)>& add_options) {
  const std::string of_which = has_instances ? " --instance left" : "";
  CLI::App app("Runs the cell's service " + program +
               " in lockstep over LCM.\nExample: " + program + of_which +
               " --url udpm://239.255.76.67:7667");
  std::string url = "udpm://239.255.76.67:7667";
  std::string deploy_dir, run_dir, instance;
  app.add_option("--url", url, "LCM address of the cell; control port: +1")
      ->capture_default_str();
  app.add_option("--deploy", deploy_dir, "folder with config/ and tasks/");
  app.add_option("--run-dir", run_dir, "folder in which the run is recorded");
  if (has_instances) {
    app.add_option("--instance", instance, "which of them, as in the roster")
        ->required();
  }
  if (add_options) add_options(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  const std::string name = has_instances ? program + "@" + instance : program;
  try {
    CellFiles files = FindCellFiles(deploy_dir);
    files.deployment.run_dir = run_dir;
    RunLcmNode(
        LcmAddress::Parse(url), files.roster, name,
        [&](Bus& bus) { return maker(bus, files.deployment, instance); },
        StopOnSignals());
    return 0;
  } catch (const std::exception& e) {
    std::cerr << name << ": " << e.what() << std::endl;
    return 1;
  }
}

}  // namespace

int RunService(const std::string& name, int argc, char** argv,
               const ServiceMaker& maker,
               const std::function<void(CLI::App&)>& add_options) {
  return Run(
      name, false, argc, argv,
      [&](Bus& bus, const Deployment& deployment, const std::string&) {
        return maker(bus, deployment);
      },
      add_options);
}

int RunInstance(const std::string& name, int argc, char** argv,
                const InstanceMaker& maker) {
  return Run(name, true, argc, argv, maker, {});
}

}  // namespace cell
