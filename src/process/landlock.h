// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::process {

/// Files that a process and all it starts may touch, held to by the kernel (Landlock, Linux 5.13; here from 5.19,
/// since before it no file could be renamed into another folder). What was opened before stays open.
class Landlock {
 public:
  /// Nothing is allowed yet. @throws core::Error(kGraphics) where the kernel has no Landlock.
  Landlock();

  /// A file, or a folder with all beneath it. What does not exist needs no permission.
  /// @throws core::Error(kIo) if it cannot be opened.
  void mayRead(const std::filesystem::path& path);
  /// The same; files may besides be made, renamed and removed in a folder. No links, pipes or devices.
  void mayWrite(const std::filesystem::path& path);

  /// From here on, for good. @pre the process has one thread, and can gain no privileges.
  void enforce() const;

 private:
  void allow(const std::filesystem::path& path, unsigned long long rights);

  int version_;
  core::FileHandle rules_;
};

}  // namespace poinsot::process
