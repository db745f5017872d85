// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::app {

/// The folder `.NAME.poinsot` beside a target, for what is not complete yet; on the target's file system, so that
/// the result can be renamed into place. Held by a lock, so that two renders of one target cannot mix; a folder
/// left by a killed run has no lock and is taken over.
class WorkFolder {
 public:
  /// @throws core::Error(kIo) if it cannot be made or another render holds it.
  explicit WorkFolder(const std::filesystem::path& target);
  /// Removes the segments and the folder.
  ~WorkFolder();
  WorkFolder(WorkFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void removeContents() const;

  std::filesystem::path path_;
  core::FileHandle lock_;
};

}  // namespace poinsot::app
