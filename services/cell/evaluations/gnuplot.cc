#include "services/cell/evaluations/gnuplot.h"

#include <sys/wait.h>

#include <csignal>
#include <cstdio>

#include "common/files/draft.h"

namespace cell::cli {
namespace {

constexpr int kNotFound = 127;  // of the shell

}  // namespace

std::string RunGnuplot(const std::string& program) {
  // A gnuplot that is not there closes the pipe.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  FILE* pipe = popen("gnuplot", "w");
  if (pipe == nullptr) return "no process for gnuplot";
  std::fwrite(program.data(), 1, program.size(), pipe);
  const int status = pclose(pipe);
  std::signal(SIGPIPE, before);
  if (status == 0) return "";
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound) {
    return "no plot: gnuplot is not installed (package gnuplot-nox)";
  }
  return "no plot: gnuplot failed";
}

std::string PictureOf(const std::string& csv_file) {
  return csv_file + ".png";
}

std::string WritePlottedTable(const std::string& csv_file,
                              const std::string& csv,
                              const std::string& program, const char* advice) {
  WriteNewFile(csv_file, csv, advice);
  const std::string problem = RunGnuplot(program);
  return "written: " + csv_file + "\n" +
         (problem.empty() ? "written: " + PictureOf(csv_file) : problem) + "\n";
}

}  // namespace cell::cli
