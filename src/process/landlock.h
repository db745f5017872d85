// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::process {

/// Access rules for files, which the kernel enforces for a process and all that it starts (Landlock). Files that
/// were opened before stay open. Requires Linux 5.19, because older versions (from 5.13) forbid renaming into
/// another folder.
class Landlock {
 public:
  /// Starts with rules that allow nothing. @throws core::Error(kGraphics) if the kernel has no Landlock
  Landlock();

  /// Allows reading a file, or a folder with everything below it. Ignores a path that does not exist.
  /// @throws core::Error(kIo) if the path cannot be opened
  void mayRead(const std::filesystem::path& path);
  /// Allows reading and writing; in a folder also making, renaming and removing files, but no links or devices.
  void mayWrite(const std::filesystem::path& path);

  /// Enforces the rules for good. @pre the process has one thread, and can gain no privileges.
  void enforce() const;

 private:
  void allow(const std::filesystem::path& path, unsigned long long rights);

  int version_;
  core::FileHandle rules_;
};

}  // namespace poinsot::process
