// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace poinsot::process {

/// Permissions of a process that reads untrusted scenes.
struct Sandbox {
  std::vector<std::filesystem::path> read;   ///< files, and folders with everything below them
  std::vector<std::filesystem::path> write;  ///< likewise, to read and write; in folders also to add and remove
  std::uint64_t mostMemory_bytes = 0;        ///< address space of one process
  std::uint64_t mostCpu_s = 0;               ///< CPU time of one process
  std::uint64_t mostFile_bytes = 0;          ///< size of one file
};

/// Puts this process and all that it starts into a sandbox for good: no other files, no program but this one, no
/// network, no privileges, no access to other processes. The system's libraries can still be loaded.
/// @pre the process has one thread.
/// @throws core::Error(kGraphics) if the kernel cannot enforce all of this; core::Error(kIo) if a file cannot be
/// opened
void enterSandbox(const Sandbox& sandbox);

/// Forbids new processes if this process is in a sandbox; otherwise does nothing. Call it in workers.
void forbidProcessesInSandbox();

}  // namespace poinsot::process
