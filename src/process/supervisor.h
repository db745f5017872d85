// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "process/sandbox.h"

namespace poinsot::process {

/// What `work` needs beside the files of its sandbox.
struct Confinement {
  Sandbox sandbox;
  /// Shader cache to give a copy of, if `work` draws: others would run one that `work` could write to. Empty:
  /// none.
  std::filesystem::path shaderCache;
};

/// Runs `work` in a process of its own, in a sandbox and with a temporary folder of its own, which is removed when
/// it ends, however that is. Signals to end are passed on.
/// @param guard  calls what it is given, and returns its exit status or that of what it threw; throws nothing.
/// @pre this process has one thread.
/// @returns its exit status; 128 + n where signal n ended it.
/// @throws core::Error where there is no room for the folder, or no process can be started.
int runConfined(Confinement confinement, const std::function<int(const std::function<int()>&)>& guard,
                const std::function<int()>& work);

}  // namespace poinsot::process
