#include "services/cell/running/process_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace cell::cli {
namespace {

void CloseBoth(int in, int copy) {
  close(in);
  if (copy >= 0) close(copy);
}

}  // namespace

ProcessOutput::~ProcessOutput() {
  for (const Pipe& pipe : pipes_) CloseBoth(pipe.in, pipe.copy);
}

int ProcessOutput::Open(const std::string& name,
                        const std::filesystem::path& copy) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "opening a pipe");
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  const int file =
      open(copy.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  pipes_.push_back({name, ends[0], file, ""});
  return ends[1];
}

std::vector<std::string> ProcessOutput::TakeLines() {
  std::vector<std::string> lines;
  std::erase_if(pipes_, [&](Pipe& pipe) {
    if (Read(pipe, &lines)) return false;
    if (!pipe.begun.empty()) OnLine(pipe, std::move(pipe.begun), &lines);
    CloseBoth(pipe.in, pipe.copy);
    return true;
  });
  return lines;
}

std::string ProcessOutput::LastLineOf(const std::string& name) const {
  const auto it = last_lines_.find(name);
  return it == last_lines_.end() ? "" : it->second;
}

bool ProcessOutput::Read(Pipe& pipe, std::vector<std::string>* lines) {
  std::array<char, 4096> buffer;
  ssize_t size = 0;
  while ((size = read(pipe.in, buffer.data(), buffer.size())) > 0) {
    const auto num = static_cast<size_t>(size);
    // On a full disk only the copy is incomplete: the screen shows everything.
    if (pipe.copy >= 0) {
      [[maybe_unused]] const ssize_t written =
          write(pipe.copy, buffer.data(), num);
    }
    pipe.begun.append(buffer.data(), num);
    size_t end = 0;
    while ((end = pipe.begun.find('\n')) != std::string::npos) {
      OnLine(pipe, pipe.begun.substr(0, end), lines);
      pipe.begun.erase(0, end + 1);
    }
  }
  return size < 0 && (errno == EAGAIN || errno == EINTR);
}

void ProcessOutput::OnLine(const Pipe& pipe, std::string line,
                           std::vector<std::string>* lines) {
  last_lines_[pipe.name] = line;
  lines->push_back(std::move(line));
}

}  // namespace cell::cli
