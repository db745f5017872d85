// SPDX-License-Identifier: Apache-2.0
#include "job/worker_heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "request/memory.h"

namespace poinsot::job {
namespace {

constexpr int kMiB = 1 << 20;
constexpr int kLargestBlock = 32 * kMiB;  // the largest M_MMAP_THRESHOLD that malloc accepts

void adviseLargePages(const char* begin, const char* end) {
  constexpr std::uintptr_t kPage = std::uintptr_t{2} * kMiB;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + kPage - 1) / kPage * kPage;
  const auto last = reinterpret_cast<std::uintptr_t>(end) / kPage * kPage;
  // NOLINTNEXTLINE(performance-no-int-to-ptr): rounded up within what sbrk() answered
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);  // failure is harmless
}

/// Returns the initial size of the heap in bytes; 0 leaves the default. Pictures of 4K leave holes as their layers
/// grow, and huge pages keep these holes in memory: 100 MiB more. Even unwritten pages count towards a limit of
/// the address space (ulimit -v), and libraries take most of that.
int beginning(double expected_bytes) {
  constexpr double kMost = 400.0 * kMiB;
  return expected_bytes < std::min(kMost, request::freeMemory().process_bytes / 4)
             ? static_cast<int>(expected_bytes)
             : 0;
}

}  // namespace

// A page fault takes 0.7 to 11 us. The start of a worker has 27 500 faults with small pages and 5700 with huge
// ones (docs/performance.md).
//
// Every picture allocates the same few blocks of its own size. If malloc returned these blocks, the kernel would
// clear them again each time, which took a fifth of the time of encoding a PNG.
void beginHeap(double expected_bytes) {
  const int bytes = beginning(expected_bytes);
  mallopt(M_MMAP_THRESHOLD, kLargestBlock);
  mallopt(M_TRIM_THRESHOLD, std::max(bytes + kLargestBlock, 128 * kMiB));
  if (bytes < kLargestBlock) return;
  constexpr int kGrows = kLargestBlock / 2;  // too large for the free rest of the parent's heap
  mallopt(M_TOP_PAD, bytes - kGrows);
  const auto* before = static_cast<const char*>(sbrk(0));
  void* volatile grows = std::malloc(kGrows);  // volatile, or the compiler drops the unused allocation
  adviseLargePages(before, static_cast<const char*>(sbrk(0)));
  std::free(grows);
  mallopt(M_TOP_PAD, kMiB);
}

}  // namespace poinsot::job
