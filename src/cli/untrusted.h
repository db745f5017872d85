// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/allowance.h"

namespace poinsot::cli {

/// What a command may touch that does not trust what it reads.
struct FileAccess {
  std::vector<std::string> scenes;        ///< files, to read with all beneath their folders
  std::vector<std::string> inputs = {};   ///< files and folders, to read
  std::vector<std::string> outputs = {};  ///< files: their folders are written to; "-" and "" are none
  std::vector<std::string> made = {};     ///< folders, made where they are missing, to write to
  std::optional<bool> reproducible = {};  ///< of those that draw
};

/// Does `work`, in a sandbox if the files are not trusted. @returns its exit status. @throws what it throws.
int confined(const AllowanceOptions& options, const std::function<FileAccess()>& accessOf,
             const std::function<int()>& work);

}  // namespace poinsot::cli
