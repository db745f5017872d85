// SPDX-License-Identifier: Apache-2.0
#include "core/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/abandoned_files.h"
#include "core/expect.h"
#include "core/file_batch.h"
#include "core/file_error.h"
#include "core/text.h"

namespace poinsot::core {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view doing, int code) {
  throw FileError(ErrorKind::kIo, fmt::format("{}: {}: {}", printable(path.native()), doing, std::strerror(code)),
                  path, code);
}

template <class Call>
int untilDone(Call call) {
  while (call() < 0)
    if (errno != EINTR) return errno;
  return 0;
}

int syncDescriptor(int descriptor) {
  return untilDone([&] { return ::fsync(descriptor); });
}

void syncPath(const std::filesystem::path& path, int flags, std::string_view doing) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | flags);
  if (descriptor < 0) fail(path, doing, errno);
  int code = syncDescriptor(descriptor);
  if (::close(descriptor) < 0 && code == 0 && errno != EINTR) code = errno;
  // EINVAL: some network and user-space file systems cannot sync folders. Such file systems keep renames in order.
  if (code == EINVAL && (flags & O_DIRECTORY) != 0) code = 0;
  if (code != 0) fail(path, doing, code);
}

}  // namespace

void makeFolders(const std::filesystem::path& folder) {
  std::error_code failure;
  const std::filesystem::path above = folderOf(folder);
  if (folder.empty() || std::filesystem::is_directory(folder, failure)) return;
  if (above != folder) makeFolders(above);
  if (std::filesystem::create_directory(folder, failure)) syncFolderOf(folder);
  if (failure) fail(folder, "cannot be created", failure.value());
}

void expectWritableFolder(const std::filesystem::path& folder) {
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, "cannot be written to", errno);
}

void appendToFile(const std::filesystem::path& target, std::string_view text) {
  struct stat before {};
  const bool wasThere = ::stat(target.c_str(), &before) == 0;
  const int descriptor = ::open(target.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(target, "cannot be opened", errno);
  const bool isFile = !wasThere || S_ISREG(before.st_mode);
  int failure = writeAll(descriptor, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (failure == 0 && isFile) failure = syncDescriptor(descriptor);
  if (::close(descriptor) < 0 && failure == 0 && errno != EINTR) failure = errno;
  if (failure == 0 && wasThere) return;
  if (failure == 0) return syncFolderOf(target);
  if (!wasThere) ::unlink(target.c_str());
  if (wasThere && isFile) untilDone([&] { return ::truncate(target.c_str(), before.st_size); });
  fail(target, "cannot be appended to", failure);
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

int writeAll(int descriptor, std::span<const std::uint8_t> bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

AtomicFile::AtomicFile(std::filesystem::path target, const std::filesystem::path& temporaryFolder)
    : target_(std::move(target)) {
  // Uses a folder on the target's file system, because a file cannot be renamed to another file system.
  const auto folder = temporaryFolder.empty() ? folderOf(target_) : temporaryFolder;
  removeAbandonedFilesOnce(folder);
  constexpr int kAttempts = 1000;
  for (int attempt = 0; attempt < kAttempts && descriptor_ < 0; ++attempt) {
    temporary_ = temporaryName(folder, target_, attempt);
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST && errno != EINTR) fail(target_, "cannot be created", errno);
  }
  if (descriptor_ < 0) fail(target_, "cannot be created", EEXIST);
}

AtomicFile::AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor)
    : target_(std::move(target)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

AtomicFile AtomicFile::of(std::filesystem::path complete, std::filesystem::path target) {
  const int descriptor = ::open(complete.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) fail(target, "cannot be created", errno);
  return {std::move(target), std::move(complete), descriptor};
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
  POINSOT_EXPECT(descriptor_ >= 0);
  if (const int code = writeAll(descriptor_, bytes); code != 0) fail(target_, "cannot be written", code);
}

void AtomicFile::write(std::string_view text) {
  write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void AtomicFile::writeAt(std::int64_t offset, std::string_view bytes) {
  if (::lseek(descriptor_, offset, SEEK_SET) < 0) fail(target_, "cannot be written", errno);
  write(bytes);
}

std::string AtomicFile::readAt(std::int64_t offset, std::size_t count) const {
  std::string bytes(count, '\0');
  std::size_t have = 0;
  while (have < count) {
    const ssize_t read =
        ::pread(descriptor_, bytes.data() + have, count - have, offset + static_cast<off_t>(have));
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) fail(target_, "cannot be read back", errno);
    if (read == 0) break;
    have += static_cast<std::size_t>(read);
  }
  bytes.resize(have);
  return bytes;
}

std::int64_t AtomicFile::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) < 0) fail(target_, "cannot be read back", errno);
  return status.st_size;
}

void AtomicFile::close() {
  // On Linux, close() releases the descriptor even if it fails, so there is no retry. After EINTR nothing is lost.
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) < 0 && errno != EINTR) fail(target_, "cannot be closed", errno);
}

void AtomicFile::finish(Durability durability) {
  if (descriptor_ < 0) return;
  if (durability == Durability::kSynced)
    if (const int code = syncDescriptor(descriptor_); code != 0) fail(target_, "cannot be synced", code);
  close();
}

void AtomicFile::rename() {
  if (std::rename(temporary_.c_str(), target_.c_str()) < 0) fail(target_, "cannot be put in place", errno);
  temporary_.clear();
}

bool AtomicFile::exchange() noexcept {
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) < 0) return false;
  temporary_.clear();
  return true;
}

void AtomicFile::commit(Durability durability) {
  POINSOT_EXPECT(descriptor_ >= 0);
  if (durability == Durability::kSynced) {
    FileBatch batch;
    batch.add(std::move(*this));
    return batch.commit();
  }
  finish(durability);
  rename();
}

void writeFileAtomically(const std::filesystem::path& target, std::span<const std::uint8_t> bytes,
                         Durability durability) {
  AtomicFile file(target);
  file.write(bytes);
  file.commit(durability);
}

void writeFileAtomically(const std::filesystem::path& target, std::string_view text) {
  AtomicFile file(target);
  file.write(text);
  file.commit();
}

void syncFile(const std::filesystem::path& file) { syncPath(file, 0, "cannot be synced"); }

void syncFolderOf(const std::filesystem::path& file) {
  syncPath(folderOf(file), O_DIRECTORY, "folder cannot be synced");
}

}  // namespace poinsot::core
