// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Paths and names are bytes, not always UTF-8, which JSON demands: each byte stands as one code point below 256.
namespace poinsot::core {

std::string utf8FromBytes(const std::string& bytes);
/// @pre made by utf8FromBytes().
std::string bytesFromUtf8(const std::string& utf8);

}  // namespace poinsot::core
