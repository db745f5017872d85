// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/limits.h"

namespace poinsot::cli {

class Command;

/// Options for limits and permissions, as the user typed them.
struct AllowanceOptions {
  std::vector<std::string> limits, assetRoots;
  std::string memory;
  std::int64_t seconds = 0;
  bool untrusted = false;
};

/// Declares --limit, --max-memory, --max-seconds and --untrusted.
void addLimitOptions(const Command& command, AllowanceOptions& options);
/// Declares the options of addLimitOptions(), and in addition --asset-root.
void addAllowance(const Command& command, AllowanceOptions& options);

/// Returns the limits, asset folders and memory as arguments for another process. Omits --max-seconds, because
/// each process has its own time limit.
std::vector<std::string> allowanceWords(const AllowanceOptions& options);

/// Returns the default limits, with the options as overrides.
/// @throws core::Error(kUsage) naming the option.
scene::Allowance allowed(const AllowanceOptions& options);

/// Returns allowed(), and starts the time limit of this process if there is one.
/// @throws core::Error(kUsage) naming the option.
scene::Allowance granted(const AllowanceOptions& options);

}  // namespace poinsot::cli
