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
  std::vector<std::string> scenes;  ///< scene files; everything in their folders is readable
  std::vector<std::string> inputs = {};
  std::vector<std::string> outputs = {};  ///< files to write; their folders are writable; ignores "-" and ""
  std::vector<std::string> made = {};     ///< writable folders, created if they are missing
  std::optional<bool> reproducible = {};  ///< value of --reproducible if the command draws; otherwise nullopt
};

/// Runs `work`, in a sandbox if --untrusted is given. @returns the exit code of `work`. @throws its exception.
int confined(const AllowanceOptions& options, const std::function<FileAccess()>& accessOf,
             const std::function<int()>& work);

}  // namespace poinsot::cli
