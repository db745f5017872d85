// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace poinsot::process {

/// Permissions and limits of a process that reads untrusted scenes.
struct Sandbox {
  std::vector<std::filesystem::path> read;   ///< files to read, and folders to read with all contents
  std::vector<std::filesystem::path> write;  ///< files and folders to write, too; folders allow new files
  std::uint64_t mostMemory_bytes = 0;        ///< address space of one process
  std::uint64_t mostCpu_s = 0;               ///< CPU time of one process
  std::uint64_t mostFile_bytes = 0;          ///< size of one file
};

/// Puts this process, and all processes that it starts, into a sandbox. The sandbox cannot be left. It allows only
/// the files in `sandbox` and the system's libraries, and no network, privileges, other programs or access to
/// other processes.
/// @pre the process has one thread.
/// @throws core::Error(kGraphics) if the kernel does not support all of these rules; core::Error(kIo) if a file
/// cannot be opened
void enterSandbox(const Sandbox& sandbox);

/// Forbids new processes if this process is in a sandbox. Does nothing otherwise. Call it in workers.
void forbidProcessesInSandbox();

}  // namespace poinsot::process
