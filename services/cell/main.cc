// cell: the operator's command line.
#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include "common/text/printable.h"
#include "common/text/printable_output.h"
#include "services/cell/commands/commands.h"

namespace {

int Run(int argc, char** argv) {
  CLI::App app(
      "A robot cell that is taught by showing.\n"
      "Example: cell demo --seed 7");
  app.require_subcommand(1);
  cell::cli::Action action;
  cell::cli::AddAllCommands(app, &action);
  try {
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    std::cerr << "cell: " << cell::Printable(e.what()) << std::endl;
    return 1;
  }
}

// False if not all of it could be written, to a full disk say.
bool FlushOutput() {
  if (std::cout.flush() && std::fflush(stdout) == 0) return true;
  // Once more, for the reason.
  errno = 0;
  std::fputc('\n', stdout);
  std::fflush(stdout);
  std::cerr << "cell: standard output cannot be written"
            << (errno != 0 ? std::string(": ") + std::strerror(errno) : "")
            << std::endl;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const cell::PrintableOutput printable_output;
  const int code = Run(argc, argv);
  return FlushOutput() || code != 0 ? code : 1;
}
