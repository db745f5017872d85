// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot {

/// What became of a command of the shell.
struct ShellResult {
  int exitCode = -1;    ///< 128 + signal if a signal ended it
  std::string out;      ///< stdout and stderr together
  double peak_MiB = 0;  ///< resident, of the largest of those processes
  double cpu_s = 0;     ///< of it and of all that it waited for; others that use the machine do not lengthen it
  double user_s = 0;  ///< of that, what is not the kernel's: the price of a page differs tenfold between machines
};

/// Runs `script` with bash in `folder` to its end. `environment`: "NAME=value", on top of this process's own.
ShellResult runShell(const std::filesystem::path& folder, const std::string& script,
                     const std::vector<std::string>& environment = {});

/// Whether a program can be found.
bool isInstalled(const std::string& program);

}  // namespace poinsot
