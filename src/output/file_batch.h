// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string_view>
#include <vector>

#include "output/atomic_file.h"

namespace poinsot::output {

/// Files that appear together or not at all: all are written and synced before the first takes its name.
///
/// A file that rests on another, as captions on their film or labels on their picture, is added beside it. The old
/// one is put aside before the main file is replaced, and the new one comes after, so a run that is killed in
/// between leaves a film without captions, never a film with the captions of another.
class FileBatch {
 public:
  FileBatch() = default;
  FileBatch(const FileBatch&) = delete;
  FileBatch& operator=(const FileBatch&) = delete;
  /// Without commit(), no name has changed and no temporary file is left.
  ~FileBatch() = default;

  /// Syncs and closes a file, which takes its name by commit(). @throws core::Error(kIo), as addBeside().
  void add(AtomicFile file);
  /// Adds a file that rests on the last one of add(). @pre there is one.
  void addBeside(AtomicFile file);
  /// The file will be gone, if it is there, with the last one of add() in its place. @pre there is one.
  void removeBeside(std::filesystem::path file);
  void writeBeside(const std::filesystem::path& target, std::string_view text);

  /// Gives all files their names. At most once. If it throws, every name stands for what it did before.
  /// @throws core::Error(kIo) with the path that failed.
  void commit();

  bool empty() const { return groups_.empty(); }

 private:
  struct Group {
    AtomicFile main;
    std::vector<AtomicFile> beside;
    std::vector<std::filesystem::path> removed;
  };
  class Changes;  // those of commit(), which can be taken back
  AtomicFile finished(AtomicFile file);
  void publish(Group& group, Changes& changes);

  std::vector<Group> groups_;
  std::set<std::filesystem::path> folders_;  // of the new files
};

}  // namespace poinsot::output
