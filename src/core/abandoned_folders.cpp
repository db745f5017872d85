// SPDX-License-Identifier: Apache-2.0
#include "core/abandoned_folders.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/atomic_file.h"
#include "core/kernel_start.h"

namespace poinsot::core {
namespace {

namespace fs = std::filesystem;

/// Name of the claim file, which contains kernelStart(). It is created after the folder is locked, and removed
/// last.
constexpr const char* kClaim = ".poinsot-claim";

bool lock(const FileHandle& folder) { return ::flock(folder.get(), LOCK_EX | LOCK_NB) == 0; }

FileHandle openFolder(const fs::path& path) {
  return FileHandle(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

/// Prefix of a folder that is about to be created or removed, when the folder may have no claim file. The prefix
/// starts with a dot so that other programs are unlikely to use the same name.
constexpr std::string_view kHidden = ".poinsot-";
constexpr std::string_view kRandom = "XXXXXX";

bool isHidden(std::string_view name) {
  return name.starts_with(kHidden) && name.size() == kHidden.size() + kRandom.size();
}

bool isNamedAsOurs(const std::string& name) { return isHidden(name) || isHidden('.' + name); }

/// Renames a folder, but never replaces an existing `to`. On file systems without RENAME_NOREPLACE, checks for
/// `to` before the rename.
bool renameToFree(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  struct stat taken {};
  return errno == EINVAL && ::lstat(to.c_str(), &taken) != 0 && errno == ENOENT &&
         std::rename(from.c_str(), to.c_str()) == 0;
}

fs::path renamed(const fs::path& folder, const std::string& name) {
  fs::path other = folder.parent_path() / name;
  return renameToFree(folder, other) ? other : folder;
}

fs::path hidden(const fs::path& folder) {
  const std::string name = folder.filename();
  return isHidden(name) ? folder : renamed(folder, '.' + name);
}

bool isOurs(const struct stat& facts, mode_t mode) {
  return facts.st_uid == ::geteuid() && (facts.st_mode & (S_IFMT | 07777)) == mode;
}

std::string claimIn(const FileHandle& folder) {
  const FileHandle file(::openat(folder.get(), kClaim, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat facts {};
  if (!file || ::fstat(file.get(), &facts) != 0 || !isOurs(facts, S_IFREG | 0600)) return "";
  std::array<char, 64> text{};
  const ssize_t size = ::read(file.get(), text.data(), text.size());
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "";
}

bool isStillAt(const fs::path& path, const FileHandle& folder) {
  struct stat here {
  }, there{};
  return ::fstat(folder.get(), &here) == 0 && ::lstat(path.c_str(), &there) == 0 && here.st_dev == there.st_dev &&
         here.st_ino == there.st_ino;
}

/// Returns whether the folder belongs to this user and could be locked. No other process removes a locked folder.
bool isFree(const fs::path& path, const FileHandle& folder) {
  struct stat facts {};
  return folder && ::fstat(folder.get(), &facts) == 0 && isOurs(facts, S_IFDIR | 0700) && lock(folder) &&
         isStillAt(path, folder);
}

/// Removes everything except the claim file, without following links. Returns true if nothing else is left.
bool removeContent(const fs::path& folder) {
  std::error_code failure;
  bool all = true;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    if (entry->path().filename() == kClaim) continue;
    std::error_code one;
    fs::remove_all(entry->path(), one);
    all = all && !one;
  }
  return all && !failure;
}

/// Returns whether the folder is empty, or contains only an empty claim file.
bool isHollow(const fs::path& folder) {
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    std::error_code unread;
    if (entry->path().filename() != kClaim || fs::file_size(entry->path(), unread) != 0 || unread) return false;
  }
  return !failure;
}

void removeIfAbandoned(const fs::path& path, const std::string& kernel) {
  const FileHandle folder = openFolder(path);
  if (!isFree(path, folder)) return;
  // This path leads to the opened folder, even if another folder takes over its name meanwhile.
  const fs::path within = fs::path("/proc/self/fd") / std::to_string(folder.get());
  const bool isClaimed = claimIn(folder) == kernel;
  if (!isClaimed && !(isHidden(path.filename().native()) && isHollow(within))) return;
  const fs::path last = hidden(path);
  if (isClaimed && !removeContent(within)) return;
  if (::unlinkat(folder.get(), kClaim, 0) == 0 || errno == ENOENT) ::rmdir(last.c_str());
}

/// Locks a new folder and writes its claim file. Returns nullopt if another process has already locked or removed
/// the folder because it looked abandoned.
std::optional<FileHandle> claim(const fs::path& folder) {
  FileHandle handle = openFolder(folder);
  if (!handle) return errno == ENOENT ? std::nullopt : std::optional(FileHandle());
  if (!lock(handle)) return errno == EWOULDBLOCK ? std::nullopt : std::optional(FileHandle());
  const FileHandle file(::openat(handle.get(), kClaim, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!file && errno == ENOENT) return std::nullopt;
  // This write may fail: the lock protects the folder. Without the claim, a killed process leaves the folder
  // behind.
  const std::string& kernel = kernelStart();
  if (file) writeAll(file.get(), {reinterpret_cast<const std::uint8_t*>(kernel.data()), kernel.size()});
  return handle;
}

}  // namespace

ClaimedFolder makeClaimedFolder(const fs::path& place) {
  constexpr int kAttempts = 100;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::string made = place / (std::string(kHidden) + std::string(kRandom));
    if (!::mkdtemp(made.data())) return ClaimedFolder();
    std::optional<FileHandle> handle = claim(made);
    if (!handle) continue;
    fs::path path = renamed(made, fs::path(made).filename().native().substr(1));
    if (path != made) return {std::move(path), std::move(*handle)};
    removeClaimedFolder(path);
  }
  errno = EAGAIN;
  return ClaimedFolder();
}

void removeClaimedFolder(const fs::path& folder) {
  std::error_code ignored;
  const fs::path last = hidden(folder);
  removeContent(last);
  fs::remove_all(last, ignored);
}

void removeAbandonedFolders(const fs::path& place) noexcept {
  try {
    const std::string& kernel = kernelStart();
    if (kernel.empty()) return;
    std::error_code ignored;
    for (fs::directory_iterator entry(place, ignored), end; !ignored && entry != end; entry.increment(ignored))
      if (isNamedAsOurs(entry->path().filename())) removeIfAbandoned(entry->path(), kernel);
  } catch (const std::exception&) {  // out of memory: the next start removes the folders
  }
}

}  // namespace poinsot::core
