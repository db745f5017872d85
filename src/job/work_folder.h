// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::job {

/// How to treat files that an earlier render left in the work folder.
enum class WorkFolderUse {
  kFresh,    ///< deletes the files
  kResumed,  ///< reuses the files
  kShared,   ///< reuses the files, and lets other processes do the same at the same time
};

/// Returns the path of the work folder: `.NAME.poinsot` in the target's folder.
std::filesystem::path workFolderOf(const std::filesystem::path& target);

/// Folder for incomplete files. It lies beside the target, because files can be renamed only within a file system.
/// A lock prevents two renders of the same target at a time. If a render is killed, its lock ends, and the next
/// render takes over the folder.
class WorkFolder {
 public:
  /// @throws core::Error(kIo) if the folder cannot be created, or if another render has locked it
  WorkFolder(const std::filesystem::path& target, WorkFolderUse use);
  /// Removes the folder, unless it is shared or contains segments that a later render can reuse.
  ~WorkFolder();
  WorkFolder(WorkFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Makes the destructor remove the folder in any case.
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
