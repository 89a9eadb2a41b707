#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "cell/type_texts.h"
#include "services/cell/commands/commands.h"

namespace cell::cli {
namespace {

int WriteTypes(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : kTypeTexts) {
    std::ofstream file(folder / name, std::ios::binary);
    file << text;
    if (!file.flush()) {
      throw std::runtime_error((folder / name).string() +
                               ": cannot be written");
    }
  }
  std::cout << fmt::format("{} message types in {}\n", std::size(kTypeTexts),
                           folder.string());
  return 0;
}

}  // namespace

void AddTypes(CLI::App& app, Action* action) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "types",
      "Write the message types that this program was built with, for lcm-gen.\n"
      "Example: cell types --out types && lcm-gen --python types/*.lcm");
  command->add_option("--out", *folder, "folder to write")->required();
  command->callback([=] {
    *action = [=] {
      return WriteTypes(*folder);
    };
  });
}

}  // namespace cell::cli
