// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot {

struct ShellResult {
  int exitCode = -1;    ///< 128 + signal number if a signal ended the command
  std::string out;      ///< stdout and stderr together
  double peak_MiB = 0;  ///< largest resident size of one of the processes
  double cpu_s = 0;     ///< of the command and all processes it waited for; other load does not lengthen it
  double user_s = 0;  ///< part of cpu_s outside the kernel, whose price of a page differs tenfold between machines
};

/// Runs `script` with bash in `folder` to its end.
/// @param environment  entries "NAME=value", added to this process's own environment
ShellResult runShell(const std::filesystem::path& folder, const std::string& script,
                     const std::vector<std::string>& environment = {});

/// Returns whether a program is on the PATH or in /usr/sbin.
bool isInstalled(const std::string& program);

}  // namespace poinsot
