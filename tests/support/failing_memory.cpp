// SPDX-License-Identifier: Apache-2.0
#include "support/failing_memory.h"

#include <link.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

extern "C" {
// Functions of glibc that the replacements below call.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace {

thread_local bool watching = false;
std::size_t count = 0, failAtCount = 0;
std::ptrdiff_t keptBlocks = 0;
bool failOnwards = false;

/// Addresses of the code of a library, or of the program, whose name is empty.
struct Range {
  std::uintptr_t begin = 0, end = 0;
  bool holds(const void* address) const {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    return at >= begin && at < end;
  }
};

Range codeOf(const char* library) {
  struct Search {
    const char* library;
    Range found;
  } search{library, {}};
  const auto look = [](dl_phdr_info* info, std::size_t, void* data) {
    auto& s = *static_cast<Search*>(data);
    const bool isIt = *s.library ? std::strstr(info->dlpi_name, s.library) != nullptr : *info->dlpi_name == 0;
    if (!isIt) return 0;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
      const auto& part = info->dlpi_phdr[i];
      if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0) continue;
      s.found = {info->dlpi_addr + part.p_vaddr, info->dlpi_addr + part.p_vaddr + part.p_memsz};
    }
    return 1;
  };
  dl_iterate_phdr(look, &search);
  return search.found;
}

Range program, standardLibrary;  // standardLibrary has operator new
bool failOwnOnly = false;

/// Fails an allocation. A debugger can stop here to see who allocated.
[[gnu::noinline]] void allocationFails() { errno = ENOMEM; }

/// Returns whether the allocation made by `caller` fails.
[[maybe_unused]] bool fails(const void* caller) {
  if (!watching || (failOwnOnly && !program.holds(caller) && !standardLibrary.holds(caller))) return false;
  ++count;
  if (failAtCount == 0 || count < failAtCount || (count > failAtCount && !failOnwards)) return false;
  allocationFails();
  return true;
}

[[maybe_unused]] void* noted(void* block) {
  if (watching && block != nullptr) ++keptBlocks;
  return block;
}

[[maybe_unused]] void forget(void* block) {
  if (watching && block != nullptr) --keptBlocks;
}

[[maybe_unused]] void* alignedBlock(std::size_t alignment, std::size_t size, const void* caller) {
  return fails(caller) ? nullptr : noted(__libc_memalign(alignment, size));
}

}  // namespace

// Sanitizers replace these functions themselves, and allocate memory before a thread has its thread-local
// variables.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" {

void* malloc(std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : noted(__libc_malloc(size));
}

void* calloc(std::size_t number, std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : noted(__libc_calloc(number, size));
}

void* realloc(void* block, std::size_t size) {
  if (fails(__builtin_return_address(0))) return nullptr;
  void* const moved = __libc_realloc(block, size);
  if (block == nullptr) return noted(moved);
  if (moved == nullptr && size == 0) forget(block);
  return moved;
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return alignedBlock(alignment, size, __builtin_return_address(0));
}

void* memalign(std::size_t alignment, std::size_t size) {
  return alignedBlock(alignment, size, __builtin_return_address(0));
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = alignedBlock(alignment, size, __builtin_return_address(0));
  return *block != nullptr ? 0 : ENOMEM;
}

void free(void* block) {
  forget(block);
  __libc_free(block);
}

}  // extern "C"
#endif

namespace poinsot {

MemoryWatch::MemoryWatch(std::size_t failAt, bool onwards, Whose whose) {
  program = codeOf("");
  standardLibrary = codeOf("libstdc++.so");
  failOwnOnly = whose == Whose::kOwn;
  count = 0;
  keptBlocks = 0;
  failAtCount = failAt;
  failOnwards = onwards;
  watching = true;
}

MemoryWatch::~MemoryWatch() { watching = false; }

std::size_t MemoryWatch::allocations() const { return count; }
std::ptrdiff_t MemoryWatch::kept() const { return keptBlocks; }

}  // namespace poinsot
