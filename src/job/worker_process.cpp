// SPDX-License-Identifier: Apache-2.0
#include "job/worker_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/error.h"
#include "job/worker.h"
#include "process/interrupt.h"
#include "process/parent_death.h"

namespace poinsot::job {
namespace {

struct Pipe {
  core::FileHandle read, write;
};

[[noreturn]] void cannotStart(const char* what) {
  throw core::graphicsError(fmt::format("cannot start a worker process: {}: {}", what, core::systemReason(errno)));
}

Pipe makePipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) cannotStart("pipe");
  return {core::FileHandle(ends[0]), core::FileHandle(ends[1])};
}

/// Closes all inherited descriptors, because open copies would keep the pipes of other workers open.
void closeAllButStandardStreams() {
  constexpr unsigned kFirst = STDERR_FILENO + 1;
  if (close_range(kFirst, ~0U, 0) == 0) return;
  rlimit limit{};  // fallback for kernels before 5.9, without close_range()
  getrlimit(RLIMIT_NOFILE, &limit);
  for (auto fd = static_cast<int>(kFirst); fd < static_cast<int>(limit.rlim_cur); ++fd) close(fd);
}

[[noreturn]] void becomeWorker(const WorkerTask& task, int segments, int reports, pid_t parent) {
  process::dieWith(parent);
  dup2(segments, STDIN_FILENO);
  dup2(reports, STDOUT_FILENO);
  closeAllButStandardStreams();
  // Calls std::exit() instead of returning, because a return would destroy the parent's objects on the stack.
  // std::exit() still lets Mesa finish its work.
  std::exit(runWorker(task, STDIN_FILENO, STDOUT_FILENO));
}

std::string inWords(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("was killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("ended with status {}", WEXITSTATUS(status));
}

}  // namespace

WorkerProcess::WorkerProcess(const WorkerTask& task, int number) : number_(number) {
  Pipe segments = makePipe(), reports = makePipe();
  const pid_t parent = getpid();
  std::fflush(nullptr);  // otherwise both processes would write the buffered text
  const process::SignalsHeld held;
  pid_ = fork();
  if (pid_ < 0) cannotStart("fork");
  if (pid_ == 0) becomeWorker(task, segments.read.get(), reports.write.get(), parent);
  segments_ = std::move(segments.write);
  reports_ = std::move(reports.read);
  reader_ = process::LineReader(reports_.get());
}

WorkerProcess::~WorkerProcess() {
  kill();
  awaitEnd(1);
}

void WorkerProcess::give(const request::FrameRange& segment) {
  segment_ = segment;
  tell(toLine(segment));
}

/// Sends a line to the worker. Throws on failure, because a worker that misses a line would wait for ever. Ignores
/// EPIPE: if the worker has ended, its reports end, too.
void WorkerProcess::tell(const std::string& line) const {
  const int code = process::writeText(segments_.get(), line + '\n');
  if (code != 0 && code != EPIPE)
    throw core::graphicsError("a message to a worker process could not be sent: " + core::systemReason(code));
}

void WorkerProcess::giveNoMore() {
  segment_.reset();
  segments_.reset();
}

std::optional<WorkerReport> WorkerProcess::takeReport() {
  const auto line = reader_.take();
  return line ? std::optional(reportFromLine(*line)) : std::nullopt;
}

void WorkerProcess::askToStop() {
  segments_.reset();
  if (pid_ > 0) ::kill(pid_, SIGTERM);
}

std::optional<std::string> WorkerProcess::ended(double wait_s) {
  awaitEnd(wait_s);
  return pid_ < 0 ? std::optional(inWords(status_)) : std::nullopt;
}

void WorkerProcess::awaitEnd(double wait_s) noexcept {
  constexpr int kPause_us = 2000;
  for (double waited_s = 0; pid_ > 0; waited_s += 1e-6 * kPause_us) {
    if (waitpid(pid_, &status_, WNOHANG) == pid_) {
      pid_ = -1;
      return;
    }
    if (waited_s >= wait_s) return;
    usleep(kPause_us);
  }
}

void WorkerProcess::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

}  // namespace poinsot::job
