#include "services/cell/running/traffic_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/text/printable.h"

namespace cell::cli {
namespace {

constexpr int kNameColumns = 24;
constexpr int kWidestTable = 66;
// A channel of LCM has at most 63 bytes, but an escaped byte takes four.
constexpr size_t kMaxName = 64;

double Megabytes(int64_t bytes) {
  return static_cast<double>(bytes) / (1 << 20);
}

std::string Percent(const std::optional<double>& share) {
  return share ? fmt::format("{:.1f}", 100 * *share) : "?";
}

std::string WideTable(const Traffic::Report& report) {
  std::string text =
      fmt::format("{:{}} {:>6} {:>8} {:>7} {:>7} {:>9}\n", "service",
                  kNameColumns, "CPU %", "MB", "lost", "late", "unknown");
  for (const Traffic::Process& p : report.processes) {
    text += fmt::format("{:{}} {:>6} {:8.1f} {:7} {:7} {:9}\n",
                        PrintableName(p.name, kMaxName), kNameColumns,
                        Percent(p.processor), Megabytes(p.resident_bytes),
                        p.num_lost, p.num_late, p.num_unknown_senders);
  }
  text += fmt::format("\n{:{}} {:>8} {:>10} {:>7} {:>9}\n", "channel",
                      kNameColumns, "Hz", "KB/s", "lost", "rejected");
  for (const Traffic::Channel& c : report.channels) {
    text +=
        fmt::format("{:{}} {:8.1f} {:10.1f} {:7} {:9}\n",
                    PrintableName(c.name, kMaxName), kNameColumns, c.rate_hz,
                    c.bytes_per_s / 1024, c.num_lost, c.num_rejected);
  }
  return text + "\n";
}

std::string NarrowTable(const Traffic::Report& report, int columns) {
  const auto max_name = static_cast<size_t>(std::max(columns, 8));
  std::string text;
  for (const Traffic::Process& p : report.processes) {
    text += fmt::format("{}\n CPU {} %, {:.1f} MB\n",
                        PrintableName(p.name, max_name), Percent(p.processor),
                        Megabytes(p.resident_bytes));
    if (p.num_lost + p.num_late + p.num_unknown_senders == 0) continue;
    text += fmt::format(" {} lost, {} late\n {} unknown senders\n", p.num_lost,
                        p.num_late, p.num_unknown_senders);
  }
  text += "\n";
  for (const Traffic::Channel& c : report.channels) {
    text += fmt::format("{}\n {:.1f} Hz, {:.1f} KB/s\n",
                        PrintableName(c.name, max_name), c.rate_hz,
                        c.bytes_per_s / 1024);
    if (c.num_lost + c.num_rejected == 0) continue;
    text += fmt::format(" {} lost, {} rejected\n", c.num_lost, c.num_rejected);
  }
  return text + "\n";
}

std::string SilenceText(const Traffic::Report& report) {
  std::string text =
      "no cell is heard here. Is one running (cell demo, cell up), and on this "
      "address (--url)?\n";
  if (report.num_foreign > 0) {
    text +=
        fmt::format("messages from outside a cell: {}\n", report.num_foreign);
  }
  return text;
}

}  // namespace

std::string TrafficTable(const Traffic::Report& report, int columns) {
  if (report.is_silent()) return SilenceText(report);
  return (columns < kWidestTable ? NarrowTable(report, columns)
                                 : WideTable(report)) +
         fmt::format("messages from outside: {}\n", report.num_foreign);
}

}  // namespace cell::cli
