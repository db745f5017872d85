// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/allowance.h"

namespace poinsot::cli {

/// Files that a command may access in the sandbox of --untrusted.
struct FileAccess {
  std::vector<std::string> scenes;  ///< scene files; their folders are readable with everything below
  std::vector<std::string> inputs = {};
  std::vector<std::string> outputs = {};  ///< files whose folders are writable; "-" and "" are ignored
  std::vector<std::string> made = {};     ///< writable folders, made if they are missing
  std::optional<bool> reproducible = {};  ///< --reproducible of a command that draws; else nullopt
};

/// Runs `work`, with --untrusted in a sandbox. @returns its exit status. @throws what it throws.
int confined(const AllowanceOptions& options, const std::function<FileAccess()>& accessOf,
             const std::function<int()>& work);

}  // namespace poinsot::cli
