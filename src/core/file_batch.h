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

/// Files that appear together or not at all: all are written and synced before the first takes its name.
///
/// A file that rests on another, as captions on their film or labels on their picture, is added beside it. The old
/// one is put aside before the main file is replaced, and the new one comes after, so a run that is killed in
/// between leaves a film without captions, never a film with the captions of another.
class FileBatch {
 public:
  /// Adds a file, which is synced and closed. @throws core::Error(kIo), as do the members below.
  void add(AtomicFile file);
  /// Adds all of another batch.
  void add(FileBatch&& others);
  /// Adds a file that rests on the last one of add(). @pre there is one.
  void addBeside(AtomicFile file);
  /// The file will be gone, if it is there, with the last one of add() in its place. @pre there is one.
  void removeBeside(std::filesystem::path file);
  void write(const std::filesystem::path& target, std::span<const std::uint8_t> bytes);
  void write(const std::filesystem::path& target, std::string_view text);
  /// @param temporaryFolder  as of AtomicFile
  void writeBeside(const std::filesystem::path& target, std::span<const std::uint8_t> bytes,
                   const std::filesystem::path& temporaryFolder = {});
  void writeBeside(const std::filesystem::path& target, std::string_view text,
                   const std::filesystem::path& temporaryFolder = {});
  /// The file will be gone, if it is there.
  void remove(std::filesystem::path file);
  /// Adds text at the end of a file, which is made if it is missing. @pre no other file is appended to.
  void append(const std::filesystem::path& target, std::string_view text);

  /// Where the content of a file of add() is until commit(); the target itself if it is none of these.
  const std::filesystem::path& contentOf(const std::filesystem::path& target) const;

  /// Gives all files their names. If it throws, every name stands for what it did before. Without it, no name has
  /// changed and no temporary file is left. A batch has one commit: another throws std::logic_error.
  /// @throws core::Error(kIo) with the path that failed.
  void commit();

  bool empty() const { return groups_.empty() && removed_.empty() && appended_.empty(); }

 private:
  struct Group {
    AtomicFile main;
    std::vector<AtomicFile> beside;
    std::vector<std::filesystem::path> removed;
  };
  class Changes;  // The names that commit() has changed so far.
  AtomicFile finished(AtomicFile file);
  void publish(Changes& changes);
  static void publish(Group& group, Changes& changes);

  std::vector<Group> groups_;
  std::set<std::filesystem::path> folders_;  // of the files
  std::vector<std::filesystem::path> removed_;
  std::filesystem::path appended_;
  std::string appendedText_;
  bool isCommitted_ = false;
};

}  // namespace poinsot::core
