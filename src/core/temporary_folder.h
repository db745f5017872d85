// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/abandoned_folders.h"

namespace poinsot::core {

/// A folder of its own, gone with all that is in it when this object is. After a SIGKILL it is gone when the next
/// one is made in the same place (abandoned_folders.h).
class TemporaryFolder {
 public:
  /// Under TMPDIR. @throws core::Error(kIo) if there is no room for it.
  TemporaryFolder();
  /// In memory, for files of which it takes many and no room; under TMPDIR where that cannot be.
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
