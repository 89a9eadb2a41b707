#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string_view>

#include "cell/type_texts.h"
#include "common/files/draft.h"
#include "services/cell/commands/commands.h"

namespace cell::cli {
namespace {

bool Holds(const std::filesystem::path& path, std::string_view text) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream old;
  old << file.rdbuf();
  return file && old.str() == text;
}

int WriteTypes(const std::filesystem::path& folder) {
  MakeFolder(folder);
  for (const auto& [name, text] : kTypeTexts) {
    if (!Holds(folder / name, text)) {
      WriteNewFile(folder / name, text,
                   "it exists with other content; choose another --out");
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
