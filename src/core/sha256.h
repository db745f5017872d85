// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::core {

using Digest = std::array<std::uint8_t, 32>;

/// SHA-256 hash (FIPS 180-4) of bytes that are added piece by piece.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;

  void add(std::span<const std::byte> bytes);
  void add(std::string_view text);
  /// Returns the digest of all added bytes. Call finish() once, last.
  Digest finish();

 private:
  struct Context;  // keeps OpenSSL's headers out of this header
  std::unique_ptr<Context> context_;
};

Digest sha256(std::string_view text);

/// Returns 64 lower-case hexadecimal digits, as sha256sum prints them.
std::string toHex(const Digest& digest);

}  // namespace poinsot::core
