// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/limits.h"

namespace poinsot::cli {

class Command;

/// Options for limits and permissions, as typed.
struct AllowanceOptions {
  std::vector<std::string> limits, assetRoots;
  std::string memory;
  std::int64_t seconds = 0;
  bool untrusted = false;
};

/// Declares --limit, --max-memory, --max-seconds and --untrusted.
void addLimitOptions(const Command& command, AllowanceOptions& options);
/// Declares the options of addLimitOptions(), and --asset-root.
void addAllowance(const Command& command, AllowanceOptions& options);

/// Returns limits, asset folders and memory as arguments for another process. Omits --max-seconds, because the
/// time limit holds for each process by itself.
std::vector<std::string> allowanceWords(const AllowanceOptions& options);

/// Returns the default limits, overridden by the options.
/// @throws core::Error(kUsage) naming the option.
scene::Allowance allowed(const AllowanceOptions& options);

/// Returns allowed(), and starts the time limit of this process if there is one.
/// @throws as allowed().
scene::Allowance granted(const AllowanceOptions& options);

}  // namespace poinsot::cli
