// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::job {

/// How a render comes to its work folder.
enum class WorkFolderUse {
  kFresh,    ///< what lies in it is thrown away
  kResumed,  ///< what lies in it is gone on with
  kShared,   ///< with others that do the same
};

/// `.NAME.poinsot` beside a target.
std::filesystem::path workFolderOf(const std::filesystem::path& target);

/// The folder beside a target for what is not complete yet; on the target's file system, so that the result can be
/// renamed into place. Held by a lock, so that two renders of one target cannot mix; a folder left by a killed run
/// has no lock and is taken over.
class WorkFolder {
 public:
  /// @throws core::Error(kIo) if it cannot be made, or another render holds it.
  WorkFolder(const std::filesystem::path& target, WorkFolderUse use);
  /// Removes the folder where there is nothing in it to go on with.
  ~WorkFolder();
  WorkFolder(WorkFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// It is removed in the end, whatever is in it.
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
