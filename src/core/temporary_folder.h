// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/abandoned_folders.h"

namespace poinsot::core {

/// Temporary folder. The destructor removes the folder with its contents. After a SIGKILL, the next
/// TemporaryFolder in the same parent folder removes it (abandoned_folders.h).
class TemporaryFolder {
 public:
  /// Creates a folder under TMPDIR. @throws core::Error(kIo) on failure.
  TemporaryFolder();
  /// Creates a folder in memory (/dev/shm), for many small files. If that fails, creates a folder under TMPDIR.
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
