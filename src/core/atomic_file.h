// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::core {

/// Durability of a file when commit() returns.
enum class Durability {
  kSynced,   ///< survives a loss of power: file and folder are synced
  kRenamed,  ///< survives the end of the process; sync later with syncFile() and syncFolderOf()
};

/// File that appears under its name only when complete. It is written under a temporary name on the same file
/// system, synced, and renamed by commit(). Without commit(), the temporary file is removed and an older target
/// stays. If a process is killed, the next process that makes a file in the same folder removes its leftovers.
class AtomicFile {
 public:
  /// Creates the temporary file.
  /// @param temporaryFolder  folder to use, on the target's file system; default: the target's own folder
  /// @throws core::Error(kIo) with the target's path and the system's reason, as do the members below
  explicit AtomicFile(std::filesystem::path target, const std::filesystem::path& temporaryFolder = {});
  /// Takes over a complete file on the target's file system. Without commit(), the destructor removes the file.
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
  /// Replaces the target. Call once, and write nothing afterwards. After an exception, the old target is still
  /// there.
  void commit(Durability durability = Durability::kSynced);

  const std::filesystem::path& target() const { return target_; }
  const std::filesystem::path& temporary() const { return temporary_; }
  /// Returns a descriptor that is open for reading and writing until commit().
  int descriptor() const { return descriptor_; }

 private:
  friend class FileBatch;
  AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor);
  /// Closes the file under its temporary name, after syncing it if kSynced.
  void finish(Durability durability);
  void rename();
  /// Swaps the names of the finished file and the target. Returns false, with nothing changed, if the file system
  /// cannot swap names.
  bool exchange() noexcept;
  void close();

  std::filesystem::path target_;
  std::filesystem::path temporary_;  // empty after the rename
  int descriptor_ = -1;
};

void writeFileAtomically(const std::filesystem::path& target, std::span<const std::uint8_t> bytes,
                         Durability durability = Durability::kSynced);

void writeFileAtomically(const std::filesystem::path& target, std::string_view text);

/// Appends text to a file, which is created if it is missing, and syncs the file. After a failure, truncates the
/// file to its earlier size, or removes a new file. @throws core::Error(kIo).
void appendToFile(const std::filesystem::path& target, std::string_view text);

/// Checks that files can be made in a folder. @throws core::Error(kIo) with the folder if not.
void expectWritableFolder(const std::filesystem::path& folder);

/// Syncs the content of a file to the disk. @throws core::Error(kIo).
void syncFile(const std::filesystem::path& file);

/// Syncs the folder of `file`, so that new names in it survive a loss of power. @throws core::Error(kIo).
void syncFolderOf(const std::filesystem::path& file);

/// Creates a folder and its missing parents, and syncs their names. @throws core::Error(kIo).
void makeFolders(const std::filesystem::path& folder);

/// Returns the parent folder of a path; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// Writes all bytes, resuming after short writes and signals. Suits callbacks that must not throw.
/// @returns 0 or an errno
int writeAll(int descriptor, std::span<const std::uint8_t> bytes) noexcept;

}  // namespace poinsot::core
