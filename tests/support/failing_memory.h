// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// Replaces malloc and its kin in a test program, to count allocations of the watching thread and to make them
/// fail. Other threads see no noticeable cost.
namespace poinsot {

/// Allocations that can fail: all of them, or only those made by the program and by libstdc++.
enum class Whose { kAll, kOwn };

/// Watches the allocations of the current thread for as long as the object lives.
class MemoryWatch {
 public:
  /// @param failAt  number of the allocation that fails, from 1; 0 for none
  /// @param onwards  whether all later allocations fail as well
  explicit MemoryWatch(std::size_t failAt = 0, bool onwards = false, Whose whose = Whose::kAll);
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;

  std::size_t allocations() const;
  /// Returns the number of allocated minus freed blocks since the watch began. Freed blocks may be older, because
  /// libraries replace blocks that they keep.
  std::ptrdiff_t kept() const;
};

}  // namespace poinsot
