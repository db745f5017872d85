// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::process {

/// Access rules for files (Landlock). The kernel enforces the rules for this process and all processes that it
/// starts. Files that are already open stay accessible. Requires Linux 5.19, because older versions forbid
/// renaming a file to another folder.
class Landlock {
 public:
  /// Creates rules that allow no access. @throws core::Error(kGraphics) if the kernel does not support Landlock
  Landlock();

  /// Allows reading a file, or a folder with all its contents. Ignores a missing path.
  /// @throws core::Error(kIo) if the path cannot be opened
  void mayRead(const std::filesystem::path& path);
  /// Allows reading and writing a file, or a folder with all its contents. In a folder, files may also be created,
  /// renamed and removed, but not links or devices.
  void mayWrite(const std::filesystem::path& path);

  /// Enforces the rules permanently. @pre the process has one thread, and can gain no privileges.
  void enforce() const;

 private:
  void allow(const std::filesystem::path& path, unsigned long long rights);

  int version_;
  core::FileHandle rules_;
};

}  // namespace poinsot::process
