// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "request/output_target.h"

namespace CLI {
class App;
}

namespace poinsot::cli {

/// Declares --bits.
void addBitsOption(CLI::App& command, int& bits);

/// @throws core::Error(kUsage) where the target takes no pictures of that many bits, saying what does.
void checkBits(int bits, const request::OutputTarget& target);

}  // namespace poinsot::cli
