// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::core {

/// How much of "written" holds when commit() returns.
enum class Durability {
  kSynced,   ///< survives a loss of power: file and folder are synced
  kRenamed,  ///< survives the end of the process; the caller syncs later with syncFile and syncFolder
};

/// A file that appears under its name only when complete: written under a temporary name on the same file system,
/// synced, renamed. Without commit() nothing is left behind and what was there before stays. What a process that
/// was killed left is removed by the next one that makes a file in the same folder.
class AtomicFile {
 public:
  /// Creates the temporary file, in `temporaryFolder` (on the target's file system) where that is given: there
  /// others find what a killed process leaves.
  /// @throws core::Error(kIo) with the target's path and the system's reason; so do all members below.
  explicit AtomicFile(std::filesystem::path target, const std::filesystem::path& temporaryFolder = {});
  /// Takes over a complete file that has another name on the target's file system. It is removed without commit().
  static AtomicFile of(std::filesystem::path complete, std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  void write(std::string_view text);
  void writeAt(std::int64_t offset, std::string_view bytes);
  /// Returns up to `count` bytes; fewer at the end of the file.
  std::string readAt(std::int64_t offset, std::size_t count) const;
  std::int64_t size() const;
  /// Replaces the target. At most once; nothing may be written afterwards. If it throws, what was there before is
  /// there again.
  void commit(Durability durability = Durability::kSynced);

  const std::filesystem::path& target() const { return target_; }
  const std::filesystem::path& temporary() const { return temporary_; }
  /// Open for reading and writing until commit().
  int descriptor() const { return descriptor_; }

 private:
  friend class FileBatch;
  AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor);
  /// Syncs and closes the file, which keeps its temporary name.
  void finish(Durability durability);
  /// Gives the finished file its name.
  void rename();
  /// Likewise, and what had the name has the temporary one then. Returns false, with nothing changed, where the
  /// file system cannot.
  bool exchange() noexcept;
  void close();

  std::filesystem::path target_;
  std::filesystem::path temporary_;  // empty once renamed
  int descriptor_ = -1;
};

void writeFileAtomically(const std::filesystem::path& target, std::span<const std::uint8_t> bytes,
                         Durability durability = Durability::kSynced);

void writeFileAtomically(const std::filesystem::path& target, std::string_view text);

/// Adds text at the end of a file, which is made if it is missing, and syncs it and its name. What was added of it
/// is removed again if not all could be. @throws core::Error(kIo).
void appendToFile(const std::filesystem::path& target, std::string_view text);

/// @throws core::Error(kIo) with the folder if no file can be made in it.
void expectWritableFolder(const std::filesystem::path& folder);

/// Makes a file's content durable. @throws core::Error(kIo).
void syncFile(const std::filesystem::path& file);

/// Makes the names in the folder of `file` durable. @throws core::Error(kIo).
void syncFolderOf(const std::filesystem::path& file);

/// Makes a folder, with those above it, where it is missing, and syncs their names. @throws core::Error(kIo).
void makeFolders(const std::filesystem::path& folder);

/// The folder of a path, "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// Writes all bytes, resuming after short writes and signals; 0 or an errno. For callbacks that must not throw.
int writeAll(int descriptor, std::span<const std::uint8_t> bytes) noexcept;

}  // namespace poinsot::core
