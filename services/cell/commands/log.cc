#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>

#include "common/bus/live_log.h"
#include "common/bus/run_log.h"
#include "common/node/cell_files.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/logs/canonical_log.h"
#include "services/cell/logs/log_audit.h"
#include "services/cell/logs/log_sequence.h"
#include "services/cell/logs/stock_reader.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

struct LogOptions {
  std::string log;
  std::string out;
  bool is_stock = false;
};

std::vector<fs::path> LogsAt(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  return RequireLogsOf(path);
}

// What kind of log it is and how much it holds.
std::string Summary(const LogIndex& index, const LogAudit& audit) {
  if (audit.manifests.empty()) {
    return fmt::format(
        "{} events, none of them a TICK of this cell's message types: cannot "
        "tell what is missing between them",
        index.entries.size());
  }
  std::string text =
      fmt::format("{}, {} events, ticks {} to {}",
                  audit.is_canonical ? "canonical" : "a stock recording",
                  index.entries.size(), audit.manifests.begin()->first,
                  audit.manifests.rbegin()->first);
  if (audit.num_unnamed > 0) {
    text += fmt::format("; {} not named by any TICK (void, repeated or forged)",
                        audit.num_unnamed);
  }
  if (audit.num_unproved > 0) {
    text += fmt::format("; {} whose TICK is lost", audit.num_unproved);
  }
  return text;
}

void PrintFindings(const LogAudit& audit) {
  for (const LogFinding& finding : audit.findings) {
    std::cout << ToString(finding) << "\n";
  }
}

// The roster is beside the log, in its run folder.
Roster RosterOf(const fs::path& log) {
  const fs::path folder = fs::is_directory(log) ? log : log.parent_path();
  const fs::path deploy = folder / "deploy";
  return FindCellFiles(fs::is_directory(deploy) ? deploy.string() : "").roster;
}

// A live cell's log is not sorted: late messages follow those in time.
std::vector<LogFinding> FindOddSequence(const LogIndex& index) {
  constexpr int64_t kMaxLateUs = 1'000'000;
  auto findings = FindOddNumbers(index, false);
  std::ranges::move(FindOddStamps(index, {.backward_us = kMaxLateUs}),
                    std::back_inserter(findings));
  return ByPlace(std::move(findings));
}

// A live cell's log has no manifests, but each sender numbers its messages.
int CheckLive(const LogOptions& options) {
  const LiveLog log = LiveLog::Load(LogsAt(options.log));
  auto problems = log.Problems(RosterOf(options.log));
  for (const LogFinding& finding :
       FindOddSequence(ReadLogIndex(LogsAt(options.log)))) {
    problems.push_back(ToString(finding));
  }
  for (const std::string& problem : problems) {
    std::cout << Printable(problem) << "\n";
  }
  std::cout << fmt::format(
      "{}: log of a live cell, {} service starts\n{}\n", Printable(options.log),
      log.incarnations().size(),
      problems.empty()
          ? "whole"
          : Counted(static_cast<int64_t>(problems.size()), "finding"));
  return problems.empty() ? 0 : 1;
}

int RunCheck(const LogOptions& options) {
  if (LiveLog::IsLive(LogsAt(options.log))) return CheckLive(options);
  const LogIndex index = ReadLogIndex(LogsAt(options.log));
  const LogAudit audit = AuditLog(index);
  PrintFindings(audit);
  std::cout << fmt::format(
      "{}: {}\n{}\n", Printable(options.log), Summary(index, audit),
      audit.findings.empty()
          ? "whole"
          : Counted(static_cast<int64_t>(audit.findings.size()), "finding"));
  if (options.is_stock) {
    for (const fs::path& file : index.files) {
      const StockReading stock = ReadAsStockToolsDo(file);
      std::cout << fmt::format(
          "{}: LCM's own reader returns {} events and {}\n",
          Printable(file.filename().string()), stock.num_events,
          Printable(stock.end));
    }
  }
  return audit.findings.empty() ? 0 : 1;
}

int RunRepair(const LogOptions& options) {
  const LogIndex index = ReadLogIndex(LogsAt(options.log));
  const LogAudit audit = AuditLog(index);
  PrintFindings(audit);
  const int64_t num = WriteCanonicalLog(index, audit, options.out);
  std::cout << fmt::format("{}: {}\n{}: {} events\n", options.log,
                           Summary(index, audit), options.out, num);
  return 0;
}

int RunConvert(const LogOptions& options) {
  const LogIndex index = ReadLogIndex(LogsAt(options.log));
  const LogAudit audit = AuditLog(index);
  PrintFindings(audit);
  if (audit.manifests.empty()) {
    throw std::runtime_error(
        options.log + ": " + Summary(index, audit) +
        ". Was the whole main port recorded (lcm-logger without --channel)?");
  }
  const int64_t num = WriteCanonicalLog(index, audit, options.out);
  std::cout << fmt::format(
      "{}: {}\n{}: {} events, {}\n", Printable(options.log),
      Summary(index, audit), options.out, num,
      audit.is_complete ? "complete" : "NOT COMPLETE: see above");
  return audit.is_complete ? 0 : 1;
}

CLI::App* AddLogCommand(CLI::App& group, const char* name, const char* help,
                        const std::shared_ptr<LogOptions>& options,
                        int (*run)(const LogOptions&), Action* action) {
  CLI::App* command = group.add_subcommand(name, help);
  command->add_option("log", options->log, "LCM log, or run folder")
      ->required()
      ->check(CLI::ExistingPath);
  command->callback([=] {
    *action = [=] {
      return run(*options);
    };
  });
  return command;
}

}  // namespace

void AddLog(CLI::App& app, Action* action) {
  CLI::App* group = app.add_subcommand(
      "log",
      "Check, repair and convert logs, including those of LCM's stock tools.\n"
      "Example: cell log check runs/sim-0001");
  group->require_subcommand(1);
  const auto options = std::make_shared<LogOptions>();
  AddLogCommand(*group, "check",
                "Find all damage, and every lost message by comparison with "
                "the TICK manifests. Exit code 1 if there is any. In a log "
                "without TICKs only damage can be found.\n"
                "Example: cell log check runs/sim-0001 --stock",
                options, RunCheck, action)
      ->add_flag("--stock", options->is_stock,
                 "also report what LCM's own reader returns");
  AddLogCommand(*group, "repair",
                "Recover the intact messages of a damaged log, and name what "
                "is lost. Exit code 0 once the new log is written.\n"
                "Example: cell log repair broken.lcmlog --out good.lcmlog",
                options, RunRepair, action)
      ->add_option("--out", options->out, "log to write")
      ->required();
  AddLogCommand(*group, "convert",
                "Convert a recording of lcm-logger into the form that `cell` "
                "writes. Exit code 1 if messages are missing; each is named.\n"
                "Example: cell log convert lcmlog-2024-05-01.00 --out "
                "run/cell-0001.lcmlog",
                options, RunConvert, action)
      ->add_option("--out", options->out, "log to write")
      ->required();
}

}  // namespace cell::cli
