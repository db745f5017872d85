// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::core {

/// Returns the bytes in Base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

/// Returns the bytes of a text in Base64. Stops at the first character that does not belong to it.
std::string fromBase64(std::string_view text);

}  // namespace poinsot::core
