// SPDX-License-Identifier: Apache-2.0
#include "process/supervisor.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "core/error.h"
#include "core/temporary_folder.h"
#include "process/interrupt.h"
#include "process/parent_death.h"

namespace poinsot::process {
namespace {

namespace fs = std::filesystem;

volatile sig_atomic_t confined = 0;  // process to which signals are forwarded

void passOn(int signal) { kill(static_cast<pid_t>(confined), signal); }

/// Scope that forwards SIGINT, SIGTERM and SIGHUP to a process. Signals that were ignored (nohup) stay ignored.
class SignalsPassedOn {
 public:
  explicit SignalsPassedOn(pid_t to) {
    confined = to;
    struct sigaction action {};
    action.sa_handler = passOn;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction before {};
      sigaction(signal, nullptr, &before);
      if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
  }
  ~SignalsPassedOn() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_IGN);  // the process has ended
  }
  SignalsPassedOn(const SignalsPassedOn&) = delete;
};

/// Copies the shader cache to a folder, which setEnvironment() later makes the cache of the new process.
void copyShaderCache(const fs::path& cache, const fs::path& folder) {
  std::error_code ignored;  // ignored: without a cache, shaders are compiled again
  if (!cache.empty()) fs::copy(cache, folder / cache.filename(), fs::copy_options::recursive, ignored);
}

void setEnvironment(const fs::path& folder, const fs::path& shaders) {
  setenv("TMPDIR", folder.c_str(), 1);
  setenv("POINSOT_CACHE", shaders.c_str(), 1);
  unsetenv("POINSOT_SHADERS");
}

int statusOf(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) != process)
    if (errno != EINTR) return EXIT_FAILURE;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

int runConfined(Confinement confinement, const std::function<int(const std::function<int()>&)>& guard,
                const std::function<int()>& work) {
  const core::TemporaryFolder folder, shaders = core::TemporaryFolder::inMemory();
  copyShaderCache(confinement.shaderCache, shaders.path());
  confinement.sandbox.write.insert(confinement.sandbox.write.end(), {folder.path(), shaders.path()});
  const pid_t supervisor = getpid();
  std::fflush(nullptr);  // otherwise both processes would write the buffered text
  std::optional<SignalsHeld> held(std::in_place);
  const pid_t process = fork();
  if (process < 0) throw core::graphicsError("--untrusted: cannot start a process: " + core::systemReason(errno));
  if (process == 0) {
    held.reset();
    dieWith(supervisor);
    setEnvironment(folder.path(), shaders.path());
    // Calls std::exit(), because a return would destroy the supervisor's objects on the stack.
    std::exit(guard([&] {
      enterSandbox(confinement.sandbox);
      return work();
    }));
  }
  const SignalsPassedOn passing(process);
  held.reset();
  return statusOf(process);
}

}  // namespace poinsot::process
