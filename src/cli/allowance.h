// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/limits.h"

namespace poinsot::cli {

class Command;

/// What the user allows, as typed.
struct AllowanceOptions {
  std::vector<std::string> limits, assetRoots;
  std::string memory;
  std::int64_t seconds = 0;
  bool untrusted = false;
};

/// Declares --limit, --max-memory, --max-seconds and --untrusted.
void addLimitOptions(const Command& command, AllowanceOptions& options);
/// Declares these and --asset-root.
void addAllowance(const Command& command, AllowanceOptions& options);

/// Limits, folders and memory as words for another process, which has a time of its own.
std::vector<std::string> allowanceWords(const AllowanceOptions& options);

/// The usual limits, above them the options.
/// @throws core::Error(kUsage) naming the option.
scene::Allowance allowed(const AllowanceOptions& options);

/// The same. Where a limit of time is among them, it runs from here on.
/// @throws as allowed().
scene::Allowance granted(const AllowanceOptions& options);

}  // namespace poinsot::cli
