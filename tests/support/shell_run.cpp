// SPDX-License-Identifier: Apache-2.0
#include "support/shell_run.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace poinsot {
namespace {

[[noreturn]] void become(const std::filesystem::path& folder, const std::string& script,
                         const std::vector<std::string>& environment, int out) {
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  for (const std::string& setting : environment) putenv(const_cast<char*>(setting.c_str()));
  if (chdir(folder.c_str()) == 0) execlp("bash", "bash", "-c", script.c_str(), nullptr);
  _exit(126);
}

std::string readAll(int fd) {
  std::string text;
  std::array<char, 4096> part;
  for (ssize_t size = 0; (size = read(fd, part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(size));
  return text;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ShellResult runShell(const std::filesystem::path& folder, const std::string& script,
                     const std::vector<std::string>& environment) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const pid_t pid = fork();
  if (pid == 0) become(folder, script, environment, ends[1]);
  close(ends[1]);
  ShellResult result;
  result.out = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  rusage spent{};
  if (pid < 0 || wait4(pid, &status, 0, &spent) < 0) throw std::runtime_error("no process");
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.user_s = seconds(spent.ru_utime);
  result.cpu_s = result.user_s + seconds(spent.ru_stime);
  result.peak_MiB = static_cast<double>(spent.ru_maxrss) / 1024;
  return result;
}

bool isInstalled(const std::string& program) {
  return runShell("/", "PATH=$PATH:/usr/sbin command -v " + program).exitCode == 0;
}

}  // namespace poinsot
