// SPDX-License-Identifier: Apache-2.0
#include "preview/program_run.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>

#include "core/error.h"
#include "core/program_path.h"
#include "core/text.h"

namespace poinsot::preview {
namespace {

[[noreturn]] void refuseRun(int why) {
  throw core::graphicsError("cannot start a process: " + core::systemReason(why));
}

/// Starts poinsot in a new process, with `errors` as standard error. Its standard input and output are /dev/null.
pid_t startProgram(const std::vector<std::string>& words, int errors) {
  const std::string program = core::programPath();
  std::vector<std::string> all{"poinsot"};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
  pid_t process = -1;
  const int why = posix_spawn(&process, program.c_str(), &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (why != 0) refuseRun(why);
  return process;
}

}  // namespace

ProgramRun::ProgramRun(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) refuseRun(errno);
  const core::FileHandle errors(ends[1]);
  errors_ = core::FileHandle(ends[0]);
  process_ = startProgram(words, errors.get());
}

ProgramRun::~ProgramRun() {
  interrupt();
  if (process_ > 0) wait([](const std::string&) {});
}

bool ProgramRun::wait(const std::function<void(const std::string& line)>& take) {
  std::string line;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(errors_.get(), buffer.data(), buffer.size())) != 0;) {
    if (count < 0 && errno != EINTR) break;
    for (ssize_t i = 0; i < count; ++i) {
      if (buffer[static_cast<std::size_t>(i)] != '\n') {
        line += buffer[static_cast<std::size_t>(i)];
        continue;
      }
      take(line);
      line.clear();
    }
  }
  // The lock keeps interrupt() from sending a signal to the process ID, which is free after waitpid().
  const std::scoped_lock lock(mutex_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void ProgramRun::interrupt() {
  const std::scoped_lock lock(mutex_);
  if (process_ > 0) kill(process_, SIGINT);
}

}  // namespace poinsot::preview
