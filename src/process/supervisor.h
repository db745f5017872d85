// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "process/sandbox.h"

namespace poinsot::process {

/// Sandbox and shader cache of the process that runConfined() starts.
struct Confinement {
  Sandbox sandbox;
  /// Shader cache to copy for the process; empty if the process draws nothing. A copy is needed because other
  /// processes run the shaders in the original, so untrusted work must not change them.
  std::filesystem::path shaderCache;
};

/// Runs `work` in a new process, in a sandbox, with a temporary folder that is removed at the end. Forwards
/// SIGINT, SIGTERM and SIGHUP to the new process.
/// @param guard  calls its argument and returns the exit code, also after an exception; never throws
/// @pre this process has one thread.
/// @returns the exit code of the new process; 128 + n if signal n ended it
/// @throws core::Error if the folder cannot be created, or if no process can be started
int runConfined(Confinement confinement, const std::function<int(const std::function<int()>&)>& guard,
                const std::function<int()>& work);

}  // namespace poinsot::process
