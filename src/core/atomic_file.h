// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::core {

/// Durability of a file after commit() returns.
enum class Durability {
  kSynced,   ///< the file survives a power failure: file and folder are synced
  kRenamed,  ///< the file survives the end of the process; call syncFile() and syncFolderOf() later
};

/// File that appears under its name only when it is complete. The content is written to a temporary file on the
/// same file system, synced, and renamed by commit(). Without commit(), the temporary file is removed and an older
/// target stays. If a process is killed, the next AtomicFile in the folder removes the temporary file.
class AtomicFile {
 public:
  /// Creates the temporary file.
  /// @param temporaryFolder  folder of the temporary file, on the target's file system; default: the target's
  /// folder
  /// @throws core::Error(kIo) with the target's path and the system's reason; all members below throw the same
  explicit AtomicFile(std::filesystem::path target, const std::filesystem::path& temporaryFolder = {});
  /// Takes over a complete file on the target's file system. Without commit(), the file is removed.
  static AtomicFile of(std::filesystem::path complete, std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  void write(std::string_view text);
  void writeAt(std::int64_t offset, std::string_view bytes);
  /// Returns `count` bytes from `offset` on, or fewer at the end of the file.
  std::string readAt(std::int64_t offset, std::size_t count) const;
  std::int64_t size() const;
  /// Replaces the target with the written file. Call commit() once, as the last member. If commit() throws, the
  /// old target is still in place.
  void commit(Durability durability = Durability::kSynced);

  const std::filesystem::path& target() const { return target_; }
  const std::filesystem::path& temporary() const { return temporary_; }
  /// Returns the descriptor of the temporary file, open for reading and writing until commit().
  int descriptor() const { return descriptor_; }

 private:
  friend class FileBatch;
  AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor);
  /// Closes the temporary file. Syncs it first if `durability` is kSynced.
  void finish(Durability durability);
  void rename();
  /// Swaps the names of the finished file and the target. Returns false if the file system cannot swap names; then
  /// nothing has changed.
  bool exchange() noexcept;
  void close();

  std::filesystem::path target_;
  std::filesystem::path temporary_;  // empty after the rename
  int descriptor_ = -1;
};

void writeFileAtomically(const std::filesystem::path& target, std::span<const std::uint8_t> bytes,
                         Durability durability = Durability::kSynced);

void writeFileAtomically(const std::filesystem::path& target, std::string_view text);

/// Appends text to a file and syncs the file; creates a missing file. After a failure, truncates the file to its
/// earlier size, or removes the new file. @throws core::Error(kIo).
void appendToFile(const std::filesystem::path& target, std::string_view text);

/// Checks that files can be created in a folder. @throws core::Error(kIo) with the folder if not.
void expectWritableFolder(const std::filesystem::path& folder);

/// Syncs the content of a file to the disk. @throws core::Error(kIo).
void syncFile(const std::filesystem::path& file);

/// Syncs the folder of `file`, so that new file names survive a power failure. @throws core::Error(kIo).
void syncFolderOf(const std::filesystem::path& file);

/// Creates a folder and its missing parents, and syncs their parents. @throws core::Error(kIo).
void makeFolders(const std::filesystem::path& folder);

/// Returns the parent folder of a path, or "." for a name without a folder.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// Writes all bytes, and continues after signals and partial writes. Never throws, so callbacks of C libraries may
/// use it.
/// @returns 0 or an errno
int writeAll(int descriptor, std::span<const std::uint8_t> bytes) noexcept;

}  // namespace poinsot::core
