// SPDX-License-Identifier: Apache-2.0
// Library to preload that makes one system call of the program on files of one folder fail, take less, or be the
// last call of the processes. Environment variables control it:
//   FAULT_CALL    tell (a write to another process of the program), open, write, fsync, close, link, rename,
//                 remove or mkdir
//   FAULT_KIND    an errno, "short" (a write takes one byte), "swap" (after a rename, another program puts the
//                 file .harness-other.png of FAULT_FOLDER there), "kill" (the process group, before the call) or
//                 "interrupt" (SIGINT to the parent, a while before the call)
//   FAULT_AT      number of the call with that name in each process, from 1; a + after it includes all later calls
//   FAULT_ROLE    worker or parent: the processes to affect
//   FAULT_FOLDER  the folder, absolute; files whose names begin with ".harness" do not count
//   FAULT_MARK    file to create when the fault has happened
//   FAULT_WITHOUT abilities that the file system lacks: "link", or "link exchange"
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

std::string setting(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

struct Plan {
  std::string call = setting("FAULT_CALL"), kind = setting("FAULT_KIND"), at = setting("FAULT_AT");
  std::string folder = setting("FAULT_FOLDER"), mark = setting("FAULT_MARK");
  std::string without = setting("FAULT_WITHOUT");
  bool inWorkers = setting("FAULT_ROLE") == "worker";
  long number = std::atol(at.c_str());
  bool onwards = at.ends_with('+');
};

const Plan& plan() {
  static const Plan made;
  return made;
}

bool isMissing(std::string_view ability) { return plan().without.find(ability) != std::string::npos; }

bool concernsPath(std::string_view path) {
  const Plan& p = plan();
  std::string whole(path);
  if (!path.starts_with('/')) {
    char cwd[4096];
    if (getcwd(cwd, sizeof cwd)) whole = std::string(cwd) + "/" + whole;
  }
  return whole.starts_with(p.folder + "/") && whole.find("/.harness") == std::string::npos;
}

bool concernsDescriptor(int fd, bool alsoReaders) {
  if (!alsoReaders && (fcntl(fd, F_GETFL) & O_ACCMODE) == O_RDONLY) return false;
  char path[4096];
  const ssize_t size = readlink(("/proc/self/fd/" + std::to_string(fd)).c_str(), path, sizeof path - 1);
  return size > 0 && path[0] == '/' && concernsPath(std::string_view(path, static_cast<std::size_t>(size)));
}

std::atomic<long> count{0};
bool isWorker = false;  // workers are forks of the program

/// Returns whether `fd` is a pipe between the program and a worker. A worker reports on its standard output.
bool leadsToAnother(int fd) {
  struct stat facts {};
  return (isWorker ? fd == STDOUT_FILENO : fd > STDERR_FILENO) && fstat(fd, &facts) == 0 &&
         S_ISFIFO(facts.st_mode);
}

__attribute__((constructor)) void begin() {
  plan();  // reads the settings now, because the program clears its environment
  pthread_atfork(nullptr, nullptr, [] {
    isWorker = true;
    count = 0;
  });
}

enum class Strike { kNone, kFail, kShort, kSwap };

/// Counts a call and returns the fault that it suffers; sets errno for a failure.
Strike strike(const char* call) {
  const Plan& p = plan();
  if (p.inWorkers != isWorker || p.call != call) return Strike::kNone;
  const long now = ++count;
  if (now < p.number || (now > p.number && !p.onwards)) return Strike::kNone;
  const long mark = syscall(SYS_open, p.mark.c_str(), O_CREAT | O_WRONLY, 0600);
  if (mark >= 0) syscall(SYS_close, mark);
  if (p.kind == "kill") {
    kill(0, SIGKILL);
    for (;;) pause();
  }
  if (p.kind == "interrupt") {
    kill(getppid(), SIGINT);
    usleep(300'000);
    return Strike::kNone;
  }
  if (p.kind == "short") return Strike::kShort;
  if (p.kind == "swap") return Strike::kSwap;
  errno = std::atoi(p.kind.c_str());
  return Strike::kFail;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

ssize_t write(int fd, const void* data, size_t size) {
  static auto* const next = real<ssize_t(int, const void*, size_t)>("write");
  if (plan().call == "write" && concernsDescriptor(fd, false)) {
    const Strike what = strike("write");
    if (what == Strike::kFail) return -1;
    if (what == Strike::kShort && size > 1) size = 1;
  }
  if (plan().call == "tell" && leadsToAnother(fd) && strike("tell") == Strike::kFail) return -1;
  return next(fd, data, size);
}

int fsync(int fd) {
  static auto* const next = real<int(int)>("fsync");
  if (plan().call == "fsync" && concernsDescriptor(fd, true) && strike("fsync") == Strike::kFail) return -1;
  return next(fd);
}

// On Linux, the descriptor is closed even if close fails.
int close(int fd) {
  static auto* const next = real<int(int)>("close");
  if (plan().call == "close" && concernsDescriptor(fd, false) && strike("close") == Strike::kFail) {
    const int why = errno;
    next(fd);
    errno = why;
    return -1;
  }
  return next(fd);
}

int link(const char* from, const char* to) {
  static auto* const next = real<int(const char*, const char*)>("link");
  if (plan().call == "link" && concernsPath(to) && strike("link") == Strike::kFail) return -1;
  if (isMissing("link") && concernsPath(to)) {
    errno = EPERM;
    return -1;
  }
  return next(from, to);
}

int rename(const char* from, const char* to) {
  static auto* const next = real<int(const char*, const char*)>("rename");
  const Strike what = plan().call == "rename" && concernsPath(to) ? strike("rename") : Strike::kNone;
  if (what == Strike::kFail) return -1;
  const int result = next(from, to);
  if (what == Strike::kSwap && (unlink(to) != 0 || link((plan().folder + "/.harness-other.png").c_str(), to) != 0))
    abort();
  return result;
}

int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned flags) {
  static auto* const next = real<int(int, const char*, int, const char*, unsigned)>("renameat2");
  if (isMissing("exchange") && concernsPath(to)) {
    errno = EINVAL;
    return -1;
  }
  if (plan().call == "rename" && concernsPath(to) && strike("rename") == Strike::kFail) return -1;
  return next(fromFolder, from, toFolder, to, flags);
}

int remove(const char* path) {
  static auto* const next = real<int(const char*)>("remove");
  if (plan().call == "remove" && concernsPath(path) && strike("remove") == Strike::kFail) return -1;
  return next(path);
}

int mkdir(const char* path, mode_t mode) {
  static auto* const next = real<int(const char*, mode_t)>("mkdir");
  if (plan().call == "mkdir" && concernsPath(path) && strike("mkdir") == Strike::kFail) return -1;
  return next(path, mode);
}

int open(const char* path, int flags, ...) {
  static auto* const next = real<int(const char*, int, ...)>("open");
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    va_list more;
    va_start(more, flags);
    mode = va_arg(more, mode_t);
    va_end(more);
    if (plan().call == "open" && concernsPath(path) && strike("open") == Strike::kFail) return -1;
  }
  return next(path, flags, mode);
}

}  // extern "C"
