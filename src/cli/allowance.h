// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/limits.h"

namespace CLI {
class App;
}  // namespace CLI

namespace poinsot::cli {

/// What the user allows, as typed.
struct AllowanceOptions {
  std::vector<std::string> limits, assetRoots;
  std::string memory;
  std::int64_t seconds = 0;
};

/// Declares --limit, --max-memory and --max-seconds.
void addLimitOptions(CLI::App& command, AllowanceOptions& options);
/// Declares these and --asset-root.
void addAllowance(CLI::App& command, AllowanceOptions& options);

/// The usual limits, above them those of the user's limits.toml, above these the options. Where a limit of time is
/// among them, it runs from here on.
/// @throws core::Error(kUsage) naming the option; scene::SceneErrors, core::Error(kIo) of limits.toml.
scene::Allowance granted(const AllowanceOptions& options);

}  // namespace poinsot::cli
