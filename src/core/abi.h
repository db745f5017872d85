// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rejects compiler flags that change the layout of types. A program with such flags would link, but compute wrong
// numbers, because the library has the types with another layout. Every public header includes this file.
#include <cstddef>
#include <version>

#if __cplusplus < 202002L
#error "poinsot: C++20 is required; compile with -std=c++20 or later"
#endif

#if defined(_GLIBCXX_DEBUG) && !defined(POINSOT_BUILT_WITH_GLIBCXX_DEBUG)
#error "poinsot: _GLIBCXX_DEBUG changes std::vector and others; build poinsot with it too, or omit it"
#elif !defined(_GLIBCXX_DEBUG) && defined(POINSOT_BUILT_WITH_GLIBCXX_DEBUG)
#error "poinsot: this library was built with _GLIBCXX_DEBUG; define it here too"
#endif
#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
#error "poinsot: _GLIBCXX_USE_CXX11_ABI=0 selects another std::string than the library's; omit it"
#endif
#ifdef EIGEN_DEFAULT_TO_ROW_MAJOR
#error "poinsot: EIGEN_DEFAULT_TO_ROW_MAJOR changes the order of a matrix's entries; omit it"
#endif

namespace poinsot::core {

/// Checks at compile time that a public type has the same size and alignment, in bytes, as in the library:
///   static_assert(core::laidOut<RigidBodyState, 120>());
template <class T, std::size_t kSize, std::size_t kAlignment = alignof(double)>
constexpr bool laidOut() {
  static_assert(sizeof(T) == kSize && alignof(T) == kAlignment,
                "poinsot: a flag or macro of this compilation gives this type another layout than it has in the "
                "library; docs/library.md, \"Flags\", lists the supported flags");
  return true;
}

}  // namespace poinsot::core
