// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::core {

/// Returns the bytes in Base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

}  // namespace poinsot::core
