// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/abandoned_folders.h"

namespace poinsot::core {

/// Temporary folder that is removed, with its contents, on destruction. After a SIGKILL, the next TemporaryFolder
/// in the same place removes it (abandoned_folders.h).
class TemporaryFolder {
 public:
  /// Makes a folder under TMPDIR. @throws core::Error(kIo) if that fails.
  TemporaryFolder();
  /// Makes a folder in memory (/dev/shm), for many small files. Falls back to TMPDIR.
  static TemporaryFolder inMemory();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return folder_.path; }

 private:
  explicit TemporaryFolder(ClaimedFolder folder);

  ClaimedFolder folder_;
};

}  // namespace poinsot::core
