// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::job {

/// Treatment of files that an earlier render left in the work folder.
enum class WorkFolderUse {
  kFresh,    ///< deletes the files
  kResumed,  ///< reuses the files
  kShared,   ///< reuses the files, and shares the folder with other processes that do the same
};

/// Returns the path `.NAME.poinsot` beside a target.
std::filesystem::path workFolderOf(const std::filesystem::path& target);

/// Folder beside a target for incomplete files, on the target's file system, so that the result can be renamed
/// into place. A lock keeps two renders of the same target apart. The folder of a killed run has no lock, so the
/// next run takes it over.
class WorkFolder {
 public:
  /// @throws core::Error(kIo) if the folder cannot be made, or if another render has locked it
  WorkFolder(const std::filesystem::path& target, WorkFolderUse use);
  /// Removes the folder, unless it is shared or holds segments that a later render can reuse.
  ~WorkFolder();
  WorkFolder(WorkFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Lets the destructor remove the folder in any case.
  void discard() { discarded_ = true; }

 private:
  void leave() const;
  bool holdsSegments() const;
  void removeContents() const;

  std::filesystem::path path_;
  core::FileHandle lock_;
  bool shared_, discarded_ = false;
};

}  // namespace poinsot::job
