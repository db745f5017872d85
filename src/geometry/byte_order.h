// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

namespace poinsot::geometry {

/// Returns the number of type T that is stored in the first bytes of `bytes`, in the byte order `order`.
/// @pre at least sizeof(T) bytes.
template <typename T>
T fromBytes(std::string_view bytes, std::endian order) {
  std::array<char, sizeof(T)> own;
  for (std::size_t i = 0; i < sizeof(T); ++i) own[i] = bytes[order == std::endian::native ? i : sizeof(T) - 1 - i];
  return std::bit_cast<T>(own);
}

}  // namespace poinsot::geometry
