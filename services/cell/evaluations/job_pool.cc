#include "services/cell/evaluations/job_pool.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <iostream>
#include <system_error>

namespace cell::cli {
namespace {

struct Worker {
  pid_t pid;
  int fd;  // its result
  size_t index;
  std::string result;
};

[[noreturn]] void Work(const std::function<std::string(size_t)>& job,
                       size_t index, int fd) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  int code = 0;
  try {
    const std::string result = job(index);
    size_t written = 0;
    while (written < result.size()) {
      const ssize_t n =
          write(fd, result.data() + written, result.size() - written);
      if (n <= 0) break;
      written += static_cast<size_t>(n);
    }
  } catch (const std::exception& e) {
    std::cerr << "job " << index << ": " << e.what() << std::endl;
    code = 1;
  }
  _exit(code);
}

Worker StartWorker(const std::function<std::string(size_t)>& job,
                   size_t index) {
  std::array<int, 2> fds{};
  if (pipe(fds.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  std::cout << std::flush;
  const pid_t pid = fork();
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid == 0) {
    close(fds[0]);
    Work(job, index, fds[1]);
  }
  close(fds[1]);
  return {pid, fds[0], index, ""};
}

// Reads what is there; returns true at the end of the worker's output.
bool Listen(Worker* worker) {
  std::array<char, 4096> buffer{};
  const ssize_t n = read(worker->fd, buffer.data(), buffer.size());
  if (n > 0) worker->result.append(buffer.data(), static_cast<size_t>(n));
  return n == 0 || (n < 0 && errno != EINTR);
}

void Bury(Worker* worker) {
  close(worker->fd);
  int status = 0;
  waitpid(worker->pid, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) worker->result.clear();
}

}  // namespace

void RunJobs(const std::vector<size_t>& indices, int num_processes,
             const std::function<std::string(size_t)>& job,
             const std::function<void(size_t, const std::string&)>& done,
             const std::function<bool()>& may_go_on) {
  std::vector<Worker> workers;
  size_t next = 0;
  while (next < indices.size() || !workers.empty()) {
    while (next < indices.size() &&
           workers.size() < static_cast<size_t>(num_processes)) {
      workers.push_back(StartWorker(job, indices[next++]));
    }
    std::vector<pollfd> descriptors;
    for (const Worker& worker : workers) {
      descriptors.push_back({worker.fd, POLLIN, 0});
    }
    constexpr int kMaxWaitMs = 500;
    poll(descriptors.data(), descriptors.size(), kMaxWaitMs);
    if (!may_go_on()) {
      for (Worker& worker : workers) {
        kill(worker.pid, SIGKILL);
        Bury(&worker);
      }
      return;
    }
    for (size_t i = workers.size(); i-- > 0;) {
      if (descriptors[i].revents == 0 || !Listen(&workers[i])) continue;
      Bury(&workers[i]);
      done(workers[i].index, workers[i].result);
      workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

}  // namespace cell::cli
