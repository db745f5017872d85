// SPDX-License-Identifier: Apache-2.0
#include "process/sandbox.h"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <string>

#include "core/error.h"
#include "core/program_path.h"
#include "process/call_filter.h"
#include "process/landlock.h"

namespace poinsot::process {
namespace {

bool inside = false;

/// Files that every program may read, without private data: library folders of Debian and others, lists of drivers
/// and libraries, CPUs (for thread counts) and available memory.
constexpr const char* kOfTheSystem[] = {"/usr/lib",
                                        "/usr/lib64",
                                        "/usr/local/lib",
                                        "/lib",
                                        "/lib64",
                                        "/etc/ld.so.cache",
                                        "/usr/share/glvnd",
                                        "/usr/share/drirc.d",
                                        "/sys/devices/system",
                                        "/sys/fs/cgroup",
                                        "/proc/meminfo",
                                        "/proc/cpuinfo",
                                        "/proc/filesystems",
                                        "/proc/self/cgroup"};

[[noreturn]] void fail(const char* what) {
  throw core::graphicsError(std::string("--untrusted: ") + what + ": " + core::systemReason(errno));
}

/// Lowers a resource limit of this process; never raises it. At the soft limit `most`, the kernel sends a signal.
/// The hard limit is higher by `warned`.
void limit(__rlimit_resource resource, std::uint64_t most, std::uint64_t warned = 0) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) fail("getrlimit");
  now.rlim_max = std::min<rlim_t>(now.rlim_max, most + warned);
  now.rlim_cur = std::min<rlim_t>({now.rlim_cur, now.rlim_max, most});
  if (setrlimit(resource, &now) != 0) fail("setrlimit");
}

void limitResources(const Sandbox& sandbox) {
  constexpr std::uint64_t kMostFiles = 1024, kMostTasks = 4096;  // of the user; not enforced for root
  limit(RLIMIT_AS, sandbox.mostMemory_bytes);
  limit(RLIMIT_FSIZE, sandbox.mostFile_bytes);
  limit(RLIMIT_NOFILE, kMostFiles);
  limit(RLIMIT_NPROC, kMostTasks);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, sandbox.mostCpu_s, 5);
}

}  // namespace

void enterSandbox(const Sandbox& sandbox) {
  Landlock files;
  for (const char* path : kOfTheSystem) files.mayRead(path);
  files.mayRead(core::ownLibraries());
  for (const auto& path : sandbox.read) files.mayRead(path);
  for (const auto& path : sandbox.write) files.mayWrite(path);
  files.mayWrite("/dev/null");
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail("no-new-privileges");
  files.enforce();
  forbidCalls();
  limitResources(sandbox);  // last, because libseccomp crashes if memory runs out while it creates a filter
  inside = true;
}

void forbidProcessesInSandbox() {
  if (inside) forbidProcesses();
}

}  // namespace poinsot::process
