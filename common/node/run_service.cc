#include "common/node/run_service.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "common/bus/lcm_node.h"
#include "common/bus/roster.h"

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

Deployment FindDeployment(const std::string& deploy_dir,
                          const std::string& task) {
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
    if (!fs::is_directory(candidate / "config")) continue;
    const Deployment deployment{candidate / "config",
                                candidate / "tasks" / task};
    if (fs::is_directory(deployment.task_dir)) return deployment;
    throw std::runtime_error("no task '" + task + "' in " +
                             deployment.task_dir.parent_path().string());
  }
  throw std::runtime_error("no deployment (a folder with config/ and tasks/) at " +
                           candidates.front().string() +
                           (deploy_dir.empty() ? " or above" : "") +
                           "; name it with --deploy DIR");
}

int RunService(const std::string& name, int argc, char** argv,
               const ServiceMaker& maker) {
  CLI::App app("Runs the cell's service " + name + " in lockstep over LCM.\n" +
               "Example: " + name + " --url udpm://239.255.76.67:7667");
  std::string url = "udpm://239.255.76.67:7667";
  std::string deploy_dir;
  std::string task = "cranfield";
  app.add_option("--url", url, "LCM address of the cell; control port: +1")
      ->capture_default_str();
  app.add_option("--deploy", deploy_dir, "folder with config/ and tasks/");
  app.add_option("--task", task, "folder under tasks/")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  try {
    const Deployment deployment = FindDeployment(deploy_dir, task);
    const Roster roster =
        Roster::FromConfig(Config::Load(deployment.config_dir / "roster.yaml"));
    RunLcmNode(
        LcmAddress::Parse(url), roster, name,
        [&](Bus& bus) { return maker(bus, deployment); }, StopOnSignals());
    return 0;
  } catch (const std::exception& e) {
    std::cerr << name << ": " << e.what() << std::endl;
    return 1;
  }
}

}  // namespace cell
