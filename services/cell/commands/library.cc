#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/library_commands.h"
#include "services/library/content_file.h"
#include "services/library/experience_check.h"
#include "services/library/experience_edits.h"
#include "services/library/memory_action_store.h"
#include "services/library/open_store.h"
#include "services/library/record_check.h"
#include "services/library/sqlite_action_store.h"

namespace cell::cli {

using namespace library;
namespace {

struct LibraryOptions {
  std::string database;
  std::string deploy_dir;
  std::string file;
  int64_t id = 0;
  bool is_verbose = false;
  bool shows_all = false;
};

std::filesystem::path DatabaseOf(const LibraryOptions& options) {
  return LibraryFile(options.database);
}

SqliteActionStore OpenExisting(const LibraryOptions& options) {
  return SqliteActionStore(DatabaseOf(options),
                           SqliteActionStore::Mode::kExisting);
}

std::string Signature(const ActionRecord& record) {
  std::vector<std::string> arguments;
  for (const auto& [name, type] : record.arguments) {
    arguments.push_back(fmt::format("{}: {}", name, type));
  }
  return Printable(
      fmt::format("{}({})", record.name, fmt::join(arguments, ", ")));
}

/// Where a record comes from: which change stored it, and what demonstrations
/// taught it.
void PrintProvenance(const ActionRecord& record, const ActionStore& store) {
  const auto change = store.ChangeOf(record.id);
  std::cout << fmt::format(
      "        version {}, {}\n", record.version,
      change
          ? Printable(fmt::format("stored by change {}: {} (build {})",
                                  change->number, change->what, change->build))
          : "stored by a change that is not kept");
  for (const std::string& line : DemonstrationsOf(record)) {
    std::cout << "        " << Printable(line) << "\n";
  }
}

/// How many experiences there are of an action.
struct ExperienceCounts {
  int64_t all = 0;
  int64_t by_robot = 0;
  int64_t unchanged = 0;
};

std::map<std::string, ExperienceCounts> CountByAction(
    const ActionStore& store) {
  std::map<std::string, ExperienceCounts> counts;
  for (const ExperienceRecord& experience : store.Experiences()) {
    ExperienceCounts& of_action = counts[experience.action];
    ++of_action.all;
    of_action.by_robot += experience.agent == "robot";
    of_action.unchanged += experience.before == experience.after;
  }
  return counts;
}

std::string ToText(const ExperienceCounts& counts) {
  return fmt::format("{}: {} by an arm, {} without a change",
                     Counted(counts.all, "experience"), counts.by_robot,
                     counts.unchanged);
}

void PrintCounts(const std::map<std::string, ExperienceCounts>& counts,
                 const ActionStore& store) {
  for (const auto& [name, of_action] : counts) {
    const auto action = store.FindNamed(name);
    std::cout << fmt::format("      {:56}  {}{}\n", Printable(name),
                             ToText(of_action),
                             !action                ? " (no such action)"
                             : action->is_removed() ? " (removed)"
                                                    : "");
  }
}

int List(const LibraryOptions& options) {
  const SqliteActionStore store = OpenExisting(options);
  for (const ActionRecord& record : store.All()) {
    if (record.is_removed() && !options.shows_all) continue;
    std::cout << fmt::format(
        "{:4}  {:56}  {}\n", record.id, Signature(record),
        record.is_removed()
            ? "removed"
            : Printable(fmt::format("{}", fmt::join(record.agents, ", "))));
    if (options.is_verbose) PrintProvenance(record, store);
  }
  PrintCounts(CountByAction(store), store);
  return 0;
}

int Changes(const LibraryOptions& options) {
  for (const StoreChange& change : OpenExisting(options).Changes()) {
    std::cout << fmt::format("{:4}  {:56}  build {}\n", change.number,
                             Printable(change.what), Printable(change.build));
  }
  return 0;
}

int Show(const LibraryOptions& options) {
  const SqliteActionStore store = OpenExisting(options);
  const auto record = store.Find(options.id);
  if (!record) {
    throw std::runtime_error(
        fmt::format("{}: no action has the id {}; cell library list shows all",
                    DatabaseOf(options).string(), options.id));
  }
  std::cout << Signature(*record) << "\n";
  PrintProvenance(*record, store);
  if (const auto counts = CountByAction(store); counts.contains(record->name)) {
    std::cout << "        " << ToText(counts.at(record->name)) << "\n";
  }
  const std::pair<const char*, std::string> entries[] = {
      {"version", std::to_string(record->version)},
      {"agents", fmt::format("{}", fmt::join(record->agents, ", "))},
      {"undoes", record->undoes},
      {"sec", record->sec},
      {"rules", record->rules},
      {"robot", record->robot},
      {"skill", record->skill},
      {"skill_settings", record->skill_settings}};
  for (const auto& [key, text] : entries) {
    if (text.empty()) continue;
    std::cout << key << ":\n";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::cout << "  " << Printable(line) << "\n";
    }
  }
  return 0;
}

int Export(const LibraryOptions& options) {
  const LibraryContent content = OpenExisting(options).Content();
  ExportContent(options.file, content);
  std::cout << fmt::format(
      "{} actions and {} are in {}\n", content.actions.size(),
      Counted(std::ssize(content.experiences), "experience"), options.file);
  return 0;
}

/// The record as it would follow `known` in its library: with the next version
/// if its own is a later one.
ActionRecord Following(ActionRecord record,
                       const std::optional<ActionRecord>& known) {
  record.id = 0;
  if (!known) {
    record.version = 1;
  } else if (record.version > known->version) {
    record.version = known->version + 1;
  }
  return record;
}

bool IsTheSame(ActionRecord record, const ActionRecord& known) {
  record.id = known.id;
  record.version = known.version;
  return record == known;
}

// Those that are there already, as they are, are passed over.
std::vector<ActionRecord> NewOnes(const std::vector<ActionRecord>& records,
                                  const RecordCheck& check,
                                  MemoryActionStore known,
                                  const std::string& file) {
  std::vector<ActionRecord> fresh;
  for (size_t i = 0; i < records.size(); ++i) {
    const auto namesake = known.FindNamed(records[i].name);
    if (namesake && IsTheSame(records[i], *namesake)) continue;
    ActionRecord record = Following(records[i], namesake);
    if (const auto refusal = check.WhyNot(record, known)) {
      throw std::runtime_error(
          fmt::format("{}:actions[{}]: {}; nothing was imported", file, i,
                      refusal->reason));
    }
    known.Store({&record, 1}, kBeforeRun);
    fresh.push_back(std::move(record));
  }
  return fresh;
}

/// The same of experiences.
std::vector<ExperienceRecord> NewExperiences(const LibraryContent& content,
                                             const LibraryContent& known,
                                             const RecordCheck& check,
                                             const std::string& file) {
  const ExperienceCheck experience_check(check.domain().vocabulary());
  auto fresh = ExperiencesMissingIn(known.experiences, content.experiences);
  MemoryActionStore all(known);
  for (ExperienceRecord& experience : fresh) {
    const int64_t id = std::exchange(experience.id, 0);
    if (const auto refusal =
            experience_check.WhyNot(ToMessage(experience), all)) {
      throw std::runtime_error(
          fmt::format("{}: experience {}: {}; nothing was imported", file, id,
                      refusal->reason));
    }
    all.Keep(experience, kBeforeRun);
  }
  return fresh;
}

int Import(const LibraryOptions& options) {
  const LibraryContent content = ReadContent(options.file);
  const auto check =
      RecordCheck::FromTask(FindCellFiles(options.deploy_dir).deployment);
  const auto database = DatabaseOf(options);
  LibraryContent known;
  if (std::filesystem::exists(database)) {
    known = OpenExisting(options).Content();
  }
  const StoreEdit fresh{
      .records = NewOnes(content.actions, check,
                         MemoryActionStore(known.actions), options.file),
      .experiences = NewExperiences(content, known, check, options.file)};
  SqliteActionStore store(database, SqliteActionStore::Mode::kCreate);
  store.BeginChange("cell library import " + options.file);
  const StoredIds ids = store.Apply(fresh, kBeforeRun);
  for (size_t i = 0; i < ids.records.size(); ++i) {
    std::cout << fmt::format("{:4}  {}\n", ids.records[i],
                             Signature(fresh.records[i]));
  }
  std::cout << fmt::format(
      "{} actions imported, {} already present; {} imported, {} already "
      "present\n",
      fresh.records.size(), content.actions.size() - fresh.records.size(),
      Counted(std::ssize(fresh.experiences), "experience"),
      content.experiences.size() - fresh.experiences.size());
  return 0;
}

}  // namespace

void AddLibrary(CLI::App& app, Action* action) {
  auto options = std::make_shared<LibraryOptions>();
  CLI::App* library = app.add_subcommand(
      "library",
      "Show, change, export or import what a cell knows: its actions and "
      "experiences.\n"
      "Example: cell library list --database runs/demo-0001");
  library->require_subcommand(1);
  const auto add = [&](const std::string& name, const std::string& text,
                       int (*run)(const LibraryOptions&)) {
    CLI::App* command = library->add_subcommand(name, text);
    command
        ->add_option("--database", options->database,
                     "a library's file, or a run folder that has one")
        ->required();
    command->callback([=] {
      *action = [=] {
        return run(*options);
      };
    });
    return command;
  };
  CLI::App* list = add(
      "list",
      "List all actions: id, arguments, and agents that can perform them; and "
      "how many experiences there are of which.\n"
      "Example: cell library list --database runs/demo-0001",
      List);
  list->add_flag("--verbose", options->is_verbose,
                 "also what stored each of them, and which demonstrations "
                 "taught it");
  list->add_flag("--all", options->shows_all, "also those that were removed");
  add("changes",
      "List what was done to the library: its runs, and the commands.\n"
      "Example: cell library changes --database library.db",
      Changes);
  add("show",
      "Show one action with its event chain, rules and skill.\n"
      "Example: cell library show 3 --database runs/demo-0001",
      Show)
      ->add_option("id", options->id)
      ->check(NumberIn<int64_t>(0))
      ->required();
  add("export",
      "Write all actions and experiences as JSON.\n"
      "Example: cell library export actions.json --database library.db",
      Export)
      ->add_option("file", options->file, "JSON file")
      ->required();
  CLI::App* import = add(
      "import",
      "Store the actions and experiences of a JSON file, all or none, as if "
      "a service had sent a request for each.\n"
      "Example: cell library import actions.json --database library.db",
      Import);
  import->add_option("file", options->file, "JSON file")->required();
  import->add_option("--deploy", options->deploy_dir,
                     "folder with config/ and tasks/");
  AddLibraryEdits(*library, action);
}

}  // namespace cell::cli
