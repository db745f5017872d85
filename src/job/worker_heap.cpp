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
constexpr int kLargestBlock = 32 * kMiB;  // the most that malloc can be told to take from its heap

void adviseLargePages(const char* begin, const char* end) {
  constexpr std::uintptr_t kPage = std::uintptr_t{2} * kMiB;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + kPage - 1) / kPage * kPage;
  const auto last = reinterpret_cast<std::uintptr_t>(end) / kPage * kPage;
  // NOLINTNEXTLINE(performance-no-int-to-ptr): rounded up within what sbrk() answered
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);  // no is an answer, too
}

/// How much the heap begins with; 0: as it is. Pictures of 4K leave holes as their layers grow, which large pages
/// would hold: 100 MiB more. And what is never written counts where a process may only have so much of addresses
/// (ulimit -v), of which libraries take most.
int beginning(double expected_bytes) {
  constexpr double kMost = 400.0 * kMiB;
  return expected_bytes < std::min(kMost, request::freeMemory().process_bytes / 4)
             ? static_cast<int>(expected_bytes)
             : 0;
}

}  // namespace

// A page fault takes 0.7 to 11 us, and a start has 27 500 of them with small pages, 5700 with this:
// docs/performance.md.
//
// Every picture asks for the same few blocks as large as itself: given back, the kernel would clear them anew each
// time, a fifth of the time of encoding a PNG.
void beginHeap(double expected_bytes) {
  const int bytes = beginning(expected_bytes);
  mallopt(M_MMAP_THRESHOLD, kLargestBlock);
  mallopt(M_TRIM_THRESHOLD, std::max(bytes + kLargestBlock, 128 * kMiB));
  if (bytes < kLargestBlock) return;
  constexpr int kGrows = kLargestBlock / 2;  // does not lie in what the parent has left of its heap
  mallopt(M_TOP_PAD, bytes - kGrows);
  const auto* before = static_cast<const char*>(sbrk(0));
  void* volatile grows = std::malloc(kGrows);  // volatile: or a block that nobody uses would not be asked for
  adviseLargePages(before, static_cast<const char*>(sbrk(0)));
  std::free(grows);
  mallopt(M_TOP_PAD, kMiB);
}

}  // namespace poinsot::job
