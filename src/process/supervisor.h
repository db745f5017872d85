// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "process/sandbox.h"

namespace poinsot::process {

/// Sandbox and shader cache of a process that runConfined() starts.
struct Confinement {
  Sandbox sandbox;
  /// Shader cache that the process gets a copy of; empty if it draws nothing. Other processes run the original, so
  /// `work` must not write to it.
  std::filesystem::path shaderCache;
};

/// Runs `work` in a new process, in a sandbox and with a temporary folder, which is removed afterwards in any
/// case. Forwards SIGINT, SIGTERM and SIGHUP to the new process.
/// @param guard  calls its argument, and returns the exit status of the call or of its exception; throws nothing
/// @pre this process has one thread.
/// @returns the exit status of the new process; 128 + n if signal n ended it
/// @throws core::Error if the folder cannot be made, or if no process can be started
int runConfined(Confinement confinement, const std::function<int(const std::function<int()>&)>& guard,
                const std::function<int()>& work);

}  // namespace poinsot::process
