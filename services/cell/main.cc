// cell: the operator's command line.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "common/text/printable.h"
#include "common/text/printable_output.h"
#include "services/cell/commands/commands.h"

static int Run(int argc, char** argv) {
  CLI::App app(
      "A robot cell that is taught by showing.\nExample: cell demo --seed 7");
  cell::cli::Action action;
  cell::cli::AddAllCommands(app, &action);
  try {
    cell::cli::CheckCommandNames(app, argc, argv);
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    std::cerr << "cell: " << cell::Printable(e.what()) << std::endl;
    return 1;
  }
}

int main(int argc, char** argv) {
  cell::PrintableOutput output;
  return output.Finish(Run(argc, argv));
}
