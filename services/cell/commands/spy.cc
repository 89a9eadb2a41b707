#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <memory>
#include <system_error>

#include "services/cell/commands/commands.h"
#include "services/cell/doctor/host_machine.h"
#include "services/cell/doctor/spy_command.h"
#include "services/cell/running/cell_address.h"

namespace cell::cli {
namespace {

struct SpyOptions {
  CellAddress address;
  std::string root;
};

int RunSpy(const SpyOptions& options) {
  const HostMachine machine;
  const auto program_dir =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const SpyParts parts =
      FindSpyParts(machine, options.root, program_dir.string());
  for (const auto& missing : parts.missing) {
    std::cerr << fmt::format("cell spy: {}; fix: {}\n", missing.what,
                             missing.fix);
  }
  if (!parts.missing.empty()) return 1;
  if (!machine.Environment("DISPLAY")) {
    std::cerr
        << "cell spy: there is no display (DISPLAY is not set): run it on "
           "a desktop, or log in with ssh -X\n";
    return 1;
  }
  const LcmAddress address = options.address.Reach();
  const std::vector<std::string> command =
      SpyCommand(parts, fmt::format("udpm://{}:{}?ttl={}", address.group,
                                    address.port, address.ttl));
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  throw std::system_error(errno, std::generic_category(), command[0]);
}

}  // namespace

void AddSpy(CLI::App& app, Action* action) {
  auto options = std::make_shared<SpyOptions>();
  CLI::App* command = app.add_subcommand(
      "spy",
      "Show a running cell's decoded messages with LCM's own lcm-spy, which "
      "loses messages larger than 100 KB.\n"
      "Example: cell spy --url udpm://239.255.76.67:7667");
  options->address.AddTo(*command);
  command->add_option("--root", options->root,
                      "folder in which to look for Java, instead of /");
  command->callback([=] {
    *action = [=] {
      return RunSpy(*options);
    };
  });
}

}  // namespace cell::cli
