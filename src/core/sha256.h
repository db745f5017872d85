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

/// Identifier of a file's content in a git repository of the usual kind: SHA-1 of a header and the content.
using GitBlob = std::array<std::uint8_t, 20>;
GitBlob gitBlob(std::string_view content);

/// Returns two lower-case hexadecimal digits for each byte, as sha256sum prints them.
std::string toHex(std::span<const std::uint8_t> bytes);

}  // namespace poinsot::core
