// SPDX-License-Identifier: Apache-2.0
// Each test runs in a process of its own, as a worker does, because settings of a heap are final. Expected values
// follow from proc_pid_smaps(5): "hg", the advice to use large pages, is a flag of a mapping.
#include "job/worker_heap.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <memory>
#include <string>

#include "support/sanitized.h"

namespace poinsot::job {
namespace {

constexpr int kMiB = 1 << 20;

/// Returns the size, in KiB, of the parts of the heap that have the advice to use large pages.
long advised_KiB() {
  std::ifstream maps("/proc/self/smaps");
  std::string line;
  long size_KiB = 0, sum_KiB = 0;
  for (bool heap = false; std::getline(maps, line);) {
    const bool opens = line.find('-') < line.find(' ');
    if (opens) heap = line.ends_with("[heap]");
    if (!heap) continue;
    if (line.starts_with("Size:")) size_KiB = std::stol(line.substr(5));
    if (line.starts_with("VmFlags:") && line.find(" hg") != std::string::npos) sum_KiB += size_KiB;
  }
  return sum_KiB;
}

/// Returns whether a check is true in a new process, which may have `limit_bytes` of address space.
template <typename Check>
bool inAProcess(Check check, rlim_t limit_bytes = RLIM_INFINITY) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (limit_bytes != RLIM_INFINITY) {
      const rlimit limit{limit_bytes, limit_bytes};
      ::setrlimit(RLIMIT_AS, &limit);
    }
    ::_exit(check() ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  return status == 0;
}

class WorkerHeap : public testing::Test {
  void SetUp() override { POINSOT_NOT_SANITIZED("it has a malloc of its own"); }
};

TEST_F(WorkerHeap, StartsInHugePages) {
  EXPECT_TRUE(inAProcess([] {
    if (advised_KiB() != 0) return false;
    ::malloc_trim(0);  // memory that other tests left at the end of the heap would be part of its growth
    beginHeap(200 * kMiB);
    return advised_KiB() >= 196 * 1024 && advised_KiB() <= 204 * 1024;
  }));
}

TEST_F(WorkerHeap, ContainsBlocksAsLargeAsAPicture) {
  EXPECT_TRUE(inAProcess([] {
    beginHeap(200 * kMiB);
    const auto* end = static_cast<const char*>(::sbrk(0));
    const std::unique_ptr<char[]> picture(new char[30 * kMiB]);
    return picture.get() < end && picture.get() > end - 200 * kMiB - 4 * kMiB;
  }));
}

TEST_F(WorkerHeap, KeepsFreedMemory) {
  EXPECT_TRUE(inAProcess([] {
    beginHeap(100 * kMiB);
    for (int i = 0; i < 3; ++i) {
      const std::unique_ptr<char[]> picture(new char[30 * kMiB]);
      std::memset(picture.get(), 1, 30 * kMiB);
    }
    rusage before{}, after{};
    ::getrusage(RUSAGE_SELF, &before);
    {
      const std::unique_ptr<char[]> picture(new char[30 * kMiB]);
      std::memset(picture.get(), 1, 30 * kMiB);
    }
    ::getrusage(RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt < 8;  // 15 if the kernel got memory back, or 7680 small ones
  }));
}

TEST_F(WorkerHeap, UsesNoHugePagesAbove400MiB) {
  EXPECT_TRUE(inAProcess([] {
    beginHeap(500.0 * kMiB);
    return advised_KiB() == 0;
  }));
}

TEST_F(WorkerHeap, UsesNoHugePagesIfAddressSpaceIsLimited) {
  EXPECT_TRUE(inAProcess(
      [] {
        beginHeap(200 * kMiB);
        const std::unique_ptr<char[]> picture(new char[30 * kMiB]);
        return advised_KiB() == 0;
      },
      rlim_t{700} * kMiB));
}

}  // namespace
}  // namespace poinsot::job
