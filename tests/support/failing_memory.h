// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// Replaces malloc and its kin in a test program: allocations of the thread that watches are counted and
/// remembered, and can be made to fail. Costs the others nothing they would notice.
namespace poinsot {

/// Which allocations fail: all, or those of the program and of C++ itself, not those of other libraries.
enum class Whose { kAll, kOwn };

/// From its construction on, until its end.
class MemoryWatch {
 public:
  /// @param failAt  which allocation fails, from 1; 0 for none
  /// @param onwards  all later ones as well
  explicit MemoryWatch(std::size_t failAt = 0, bool onwards = false, Whose whose = Whose::kAll);
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;

  std::size_t allocations() const;
  /// Blocks that were taken since its begin less those given back, of which some may be older: libraries put a new
  /// one in the place of what they keep.
  std::ptrdiff_t kept() const;
};

}  // namespace poinsot
