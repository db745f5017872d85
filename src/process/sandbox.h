// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace poinsot::process {

/// What a process that reads a stranger's scene may still do.
struct Sandbox {
  std::vector<std::filesystem::path> read;   ///< files, and folders with all beneath them
  std::vector<std::filesystem::path> write;  ///< the same, to read, to write, and in folders to make and remove
  std::uint64_t mostMemory_bytes = 0;        ///< address space of one process
  std::uint64_t mostCpu_s = 0;               ///< of one process
  std::uint64_t mostFile_bytes = 0;          ///< of one file
};

/// Puts this process, and all that it starts, into it for good: no other files, no program but this one, no
/// network, no privileges, no look at other processes. Libraries of the system may still be loaded.
/// @pre the process has one thread.
/// @throws core::Error(kGraphics) where the kernel cannot hold it to all of that; (kIo) for a file that cannot be
/// opened.
void enterSandbox(const Sandbox& sandbox);

/// In a worker of such a process: it starts no others either. Does nothing in any other.
void forbidProcessesInSandbox();

}  // namespace poinsot::process
