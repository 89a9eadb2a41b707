#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "cell/command_library_t.hpp"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/library_commands.h"
#include "services/cell/running/operator_port.h"
#include "services/library/experience_check.h"
#include "services/library/open_store.h"
#include "services/library/record_edits.h"
#include "services/library/sqlite_action_store.h"

namespace cell::cli {

using namespace library;
namespace {

struct EditOptions {
  std::string database;
  std::string deploy_dir;
  std::string name;
  std::string other;
  int64_t number = 0;
  OperatorOptions port;
};

using EditFunction =
    std::function<Result<StoreEdit>(const RecordEdits&, const ActionStore&)>;

/// An edit as a command to a running cell, and as one on a database.
struct Edit {
  int8_t kind = 0;
  std::string title;  ///< "rename A B"
  EditFunction on_database;
};

int CommandEdit(const EditOptions& options, const Edit& edit) {
  OperatorPort port(options.port,
                    {"COMMAND_LIBRARY", "library", "library " + edit.title});
  command_library_t command{};
  command.kind = edit.kind;
  command.name = options.name;
  command.other = options.other;
  return port.Execute(command);
}

int EditDatabase(const EditOptions& options, const Edit& edit) {
  const auto check =
      RecordCheck::FromTask(FindCellFiles(options.deploy_dir).deployment);
  const auto file = LibraryFile(options.database);
  SqliteActionStore store(file, SqliteActionStore::Mode::kExisting);
  auto why_of_another = check.WhyOfAnotherTask(store);
  if (!why_of_another) {
    why_of_another =
        ExperienceCheck(check.domain().vocabulary()).WhyOfAnotherTask(store);
  }
  if (why_of_another) {
    throw std::runtime_error(file.string() + ": its " + *why_of_another +
                             "; name its task's --deploy");
  }
  const LibraryContent content = store.Content();
  const auto changes = edit.on_database(
      RecordEdits(content, check.domain(), check.parts()), store);
  const std::string why =
      changes ? WhyNotAll(changes->records, check, store) : changes.reason();
  if (!why.empty()) {
    throw std::runtime_error(
        fmt::format("{}: {}; nothing was changed", file.string(), why));
  }
  store.BeginChange("cell library " + edit.title);
  const std::vector<int64_t> ids = store.Apply(*changes, kBeforeRun).records;
  for (size_t i = 0; i < ids.size(); ++i) {
    const ActionRecord& record = changes->records[i];
    std::cout << fmt::format("{:4}  {}, version {}{}\n", ids[i],
                             Printable(record.name), record.version,
                             record.is_removed() ? ": removed" : "");
  }
  if (changes->has_experiences()) {
    std::cout << fmt::format(
        "{} stored, {} removed\n",
        Counted(std::ssize(changes->experiences), "experience"),
        std::ssize(changes->removed_experiences));
  }
  std::cout << fmt::format("this is change {} of {}\n",
                           store.Changes().back().number, file.string());
  return 0;
}

int RunEdit(const EditOptions& options, const Edit& edit) {
  return options.database.empty() ? CommandEdit(options, edit)
                                  : EditDatabase(options, edit);
}

Result<StoreEdit> RollBack(const RecordEdits& edits, const ActionStore& store,
                           int64_t number) {
  const auto changes = store.Changes();
  if (changes.empty()) return Reason{"no change of it is kept"};
  if (number == 0) number = changes.back().number;
  const auto earlier = store.ContentBefore(number);
  if (!earlier) {
    return Reason{fmt::format("change {} is not kept; {} to {} are", number,
                              changes.front().number, changes.back().number)};
  }
  return edits.Restore(*earlier);
}

}  // namespace

std::filesystem::path LibraryFile(const std::string& database) {
  const std::filesystem::path path = database;
  return std::filesystem::is_directory(path) ? path / kDatabaseName : path;
}

std::vector<std::string> DemonstrationsOf(const ActionRecord& record) {
  std::vector<std::string> lines;
  const auto add = [&](const YAML::Node& counts, const std::string& build) {
    for (const auto& entry : counts) {
      lines.push_back(fmt::format(
          "shown {} by {}{}", Counted(entry.second.as<int64_t>(), "time"),
          entry.first.as<std::string>(),
          build.empty() ? "" : fmt::format(" (build {})", build)));
    }
  };
  try {
    const YAML::Node sec = YAML::Load(record.sec);
    if (!sec.IsMap()) return lines;
    for (const YAML::Node& taught : sec["taught"]) {
      add(taught["by"], taught["build"].as<std::string>(""));
    }
    if (lines.empty() && sec["shown"]) add(sec["shown"], "");
  } catch (const YAML::Exception&) {
    lines = {"its event chain cannot be read"};
  }
  return lines;
}

namespace {

/// "rename A B"
std::string TitleOf(const std::string& command, const EditOptions& options) {
  std::string title = command;
  for (const std::string& word : {options.name, options.other}) {
    if (!word.empty()) title += " " + word;
  }
  if (options.number > 0) title += " " + std::to_string(options.number);
  return title;
}

/// The subcommands of `cell library` that edit, which share their options.
class EditCommands {
 public:
  EditCommands(CLI::App& library, Action* action)
      : library_(library), action_(action) {}

  void AddRename();
  void AddRemove();
  void AddMerge();
  void AddTakeBack();
  void AddRollBack();

 private:
  CLI::App* Add(const std::string& name, const std::string& text, int8_t kind,
                EditFunction on_database);
  void AddName(CLI::App* command, const char* text) {
    command->add_option("name", options_->name, text)->required();
  }
  void AddOther(CLI::App* command, const char* text) {
    command->add_option("other", options_->other, text)->required();
  }

  CLI::App& library_;
  Action* action_;
  std::shared_ptr<EditOptions> options_ = std::make_shared<EditOptions>();
};

CLI::App* EditCommands::Add(const std::string& name, const std::string& text,
                            int8_t kind, EditFunction on_database) {
  CLI::App* command = library_.add_subcommand(name, text);
  command->add_option("--database", options_->database,
                      "a library's file, or a run folder that has one "
                      "(default: the cell running on this network)");
  command->add_option("--deploy", options_->deploy_dir,
                      "of a database: folder with config/ and tasks/");
  AddOperatorOptions(*command, &options_->port);
  command->callback([=, options = options_, action = action_] {
    *action = [=] {
      return RunEdit(*options, {kind, TitleOf(name, *options), on_database});
    };
  });
  return command;
}

void EditCommands::AddRename() {
  CLI::App* command =
      Add("rename",
          "Give an action another name.\n"
          "Example: cell library rename Action1 PlaceBolt",
          command_library_t::RENAME,
          [options = options_](const RecordEdits& edits, const ActionStore&) {
            return edits.Rename(options->name, options->other);
          });
  AddName(command, "of an action");
  AddOther(command, "its new name");
}

void EditCommands::AddRemove() {
  CLI::App* command =
      Add("remove",
          "Remove an action: it is not recognised or planned any more. Its "
          "experiences are kept, and not told to anyone.\n"
          "Example: cell library remove Action1 --database library.db",
          command_library_t::REMOVE,
          [options = options_](const RecordEdits& edits, const ActionStore&) {
            return edits.Remove(options->name);
          });
  AddName(command, "of an action");
}

void EditCommands::AddMerge() {
  CLI::App* command =
      Add("merge",
          "What was learned of an action becomes part of another, and "
          "the action is removed.\n"
          "Example: cell library merge Action1 PlaceBolt",
          command_library_t::MERGE,
          [options = options_](const RecordEdits& edits, const ActionStore&) {
            return edits.Merge(options->name, options->other);
          });
  AddName(command, "of an action");
  AddOther(command, "of the action that it becomes part of");
}

void EditCommands::AddTakeBack() {
  CLI::App* command =
      Add("take-back",
          "Forget what a demonstration has taught: its actions go back "
          "to what the others have taught, and what people did in it is no "
          "experience any more.\n"
          "Example: cell library take-back \"assembly 2\" --database "
          "library.db",
          command_library_t::TAKE_BACK,
          [options = options_](const RecordEdits& edits, const ActionStore&) {
            return edits.TakeBack(options->name);
          });
  AddName(command, "of a demonstration, as in cell library list --verbose");
}

void EditCommands::AddRollBack() {
  Add("rollback",
      "Go back to what the library held before a change (cell library "
      "changes), without the number before the last one; a running cell goes "
      "back to what it held when its run began.\n"
      "Example: cell library rollback 3 --database library.db",
      command_library_t::ROLL_BACK,
      [options = options_](const RecordEdits& edits, const ActionStore& store) {
        return RollBack(edits, store, options->number);
      })
      ->add_option("number", options_->number, "of the first change undone")
      ->check(NumberIn<int64_t>(1));
}

}  // namespace

void AddLibraryEdits(CLI::App& library, Action* action) {
  EditCommands commands(library, action);
  commands.AddRename();
  commands.AddRemove();
  commands.AddMerge();
  commands.AddTakeBack();
  commands.AddRollBack();
}

}  // namespace cell::cli
