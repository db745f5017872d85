// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/atomic_file.h"

namespace poinsot::core {

/// Files that appear together or not at all. All files are written and synced before the first is renamed.
///
/// A main file may have companions that depend on it, such as the captions of a film or the labels of a picture.
/// An old companion is removed before its main file is replaced, and the new companion follows. If the process is
/// killed in between, a film may lack captions, but never has the captions of another film.
class FileBatch {
 public:
  /// Adds a file, and syncs and closes it. @throws core::Error(kIo); all members below throw the same.
  void add(AtomicFile file);
  /// Moves all files of another batch into this batch. The other batch must not append to a file.
  void add(FileBatch&& others);
  /// Adds a companion of the last file of add(). @pre there is one.
  void addBeside(AtomicFile file);
  /// Removes `file`, if it exists, when the last file of add() is renamed. @pre there is one.
  void removeBeside(std::filesystem::path file);
  void write(const std::filesystem::path& target, std::span<const std::uint8_t> bytes);
  void write(const std::filesystem::path& target, std::string_view text);
  void writeBeside(const std::filesystem::path& target, std::span<const std::uint8_t> bytes,
                   const std::filesystem::path& temporaryFolder = {});
  void writeBeside(const std::filesystem::path& target, std::string_view text,
                   const std::filesystem::path& temporaryFolder = {});
  /// Removes `file`, if it exists, on commit().
  void remove(std::filesystem::path file);
  /// Appends text to a file on commit(); creates the file if it is missing. @pre no other file is appended to.
  void append(const std::filesystem::path& target, std::string_view text);

  /// Returns the path where the content of `target` can be read before commit(): the temporary file if `target`
  /// was added, otherwise `target` itself.
  const std::filesystem::path& contentOf(const std::filesystem::path& target) const;

  /// Renames all files to their targets. If commit() throws, it first restores all names. If commit() is never
  /// called, no name changes and no temporary file is left. A second call throws std::logic_error.
  /// @throws core::Error(kIo) with the path that failed
  void commit();

  bool empty() const { return groups_.empty() && removed_.empty() && appended_.empty(); }

 private:
  struct Group {
    AtomicFile main;
    std::vector<AtomicFile> beside;
    std::vector<std::filesystem::path> removed;
  };
  class Changes;
  AtomicFile finished(AtomicFile file);
  void publish(Changes& changes);
  static void publish(Group& group, Changes& changes);

  std::vector<Group> groups_;
  std::set<std::filesystem::path> folders_;  // folders to sync on commit()
  std::vector<std::filesystem::path> removed_;
  std::filesystem::path appended_;
  std::string appendedText_;
  bool isCommitted_ = false;
};

}  // namespace poinsot::core
