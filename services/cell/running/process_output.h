#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cell::cli {

/// The output of processes, line by line: through a pipe each, so that a full
/// disk hides nothing. A copy goes to a file while there is room. Device
/// adapter.
class ProcessOutput {
 public:
  ProcessOutput() = default;
  ProcessOutput(const ProcessOutput&) = delete;
  ProcessOutput& operator=(const ProcessOutput&) = delete;
  ~ProcessOutput();

  /// The end of a new pipe that process `name` is to write to; the caller
  /// closes it after the start. The output is also appended to `copy`. @throws
  /// std::system_error if there is no pipe.
  int Open(const std::string& name, const std::filesystem::path& copy);

  /// The whole lines that have come since the last call, and the incomplete
  /// last line of a process that has ended.
  std::vector<std::string> TakeLines();

  /// The last line of `name` among those taken; empty if none.
  std::string LastLineOf(const std::string& name) const;

 private:
  struct Pipe {
    std::string name;
    int in = -1;
    int copy = -1;  // -1: there is no room for one
    std::string begun;
  };

  /// False at its end.
  bool Read(Pipe& pipe, std::vector<std::string>* lines);
  void OnLine(const Pipe& pipe, std::string line,
              std::vector<std::string>* lines);

  std::vector<Pipe> pipes_;
  std::map<std::string, std::string> last_lines_;
};

}  // namespace cell::cli
