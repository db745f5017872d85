// SPDX-License-Identifier: Apache-2.0
// Library to preload that tests the sandbox. When the program first renames a file into place, the library tries
// the actions of a stranger who controls the process. It reports each result on stderr: "probe worker socket:
// Operation not permitted", or "probe worker socket: done". Environment variables control it:
//   PROBE_OUTSIDE      a file that the program does not need
//   PROBE_NO_LANDLOCK  if set, the kernel behaves as one without Landlock
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/landlock.h>
#include <pthread.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

/// Settings, read when the library is loaded, because the program clears its environment.
const char* const kOutside = std::getenv("PROBE_OUTSIDE");
const char* const kNoLandlock = std::getenv("PROBE_NO_LANDLOCK");

int depth = 0;  // number of forks: 0 in the program, 1 in the confined process, 2 in its workers

__attribute__((constructor)) void countForks() {
  pthread_atfork(nullptr, nullptr, [] { ++depth; });
}

void tell(const char* what, long result) {
  const char* who = depth > 1 ? "worker" : depth == 1 ? "parent" : "program";
  dprintf(STDERR_FILENO, "probe %s %s: %s\n", who, what, result >= 0 ? "done" : std::strerror(errno));
}

/// Returns only after an error.
long execute() {
  char name[] = "/bin/true";
  char* const arguments[] = {name, nullptr};
  return execve(name, arguments, nullptr);
}

void tryAll() {
  const std::string outside = kOutside;
  tell("passwd", open("/etc/passwd", O_RDONLY));
  tell("outside", open(outside.c_str(), O_RDONLY));
  tell("overwrite", open(outside.c_str(), O_WRONLY));
  tell("create", open((outside + ".new").c_str(), O_CREAT | O_WRONLY, 0600));
  tell("remove", unlink(outside.c_str()));
  tell("list", open("/", O_RDONLY | O_DIRECTORY));
  tell("environment", open("/proc/1/environ", O_RDONLY));
  tell("socket", socket(AF_INET, SOCK_STREAM, 0));
  tell("local-socket", socket(AF_UNIX, SOCK_STREAM, 0));
  // The control run does these as root, so they affect missing files or nothing.
  tell("ptrace", ptrace(PTRACE_PEEKDATA, getpid(), nullptr, nullptr));
  tell("mount", mount("none", "/no/such", "tmpfs", 0, nullptr));
  tell("namespace", syscall(SYS_unshare, 0));
  tell("link", symlink("/etc/passwd", "probe-link"));
  tell("pipe", mkfifo("probe-pipe", 0600));
  tell("keys", syscall(SYS_keyctl, 0, -3, 1));
  if (depth > 1) {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    tell("fork", child);
  }
  tell("execute", execute());
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int rename(const char* from, const char* to) {
  static auto* const next = real<int(const char*, const char*)>("rename");
  static int triedAt = -1;
  if (triedAt != depth && kOutside) {
    triedAt = depth;
    tryAll();
  }
  return next(from, to);
}

// Replaces syscall(), which serves system calls without a glibc function.
long syscall(long number, ...) {
  static auto* const next = real<long(long, ...)>("syscall");
  va_list rest;
  va_start(rest, number);
  long a[6];
  for (long& value : a) value = va_arg(rest, long);
  va_end(rest);
  if (number == SYS_landlock_create_ruleset && kNoLandlock) {
    errno = ENOSYS;
    return -1;
  }
  return next(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}

}  // extern "C"
