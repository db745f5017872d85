// SPDX-License-Identifier: Apache-2.0
#include "app/abandoned_folders.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;
using core::FileHandle;

/// Holds the number of the kernel's start. Made when the lock is held already, removed last.
constexpr const char* kClaim = ".poinsot-claim";

/// Differs from one start of a kernel to the next; the same in all its containers. Empty without /proc.
std::string kernelStart() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string line;
  std::getline(file, line);
  return line;
}

bool lock(const FileHandle& folder) { return ::flock(folder.get(), LOCK_EX | LOCK_NB) == 0; }

FileHandle openFolder(const fs::path& path) {
  return FileHandle(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

bool isNamedAsOurs(std::string_view name) {
  constexpr std::string_view kStart = "poinsot-";
  return name.starts_with(kStart) && name.size() == kStart.size() + 6;
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

/// Whether the name still stands for it. Once locked, nobody else removes it.
bool isStillAt(const fs::path& path, const FileHandle& folder) {
  struct stat here {
  }, there{};
  return ::fstat(folder.get(), &here) == 0 && ::lstat(path.c_str(), &there) == 0 && here.st_dev == there.st_dev &&
         here.st_ino == there.st_ino;
}

bool isAbandoned(const fs::path& path, const FileHandle& folder, const std::string& kernel) {
  struct stat facts {};
  return folder && ::fstat(folder.get(), &facts) == 0 && isOurs(facts, S_IFDIR | 0700) &&
         claimIn(folder) == kernel && lock(folder) && isStillAt(path, folder);
}

/// Links within are removed, not followed. @returns whether nothing but the claim is left.
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

void removeIfAbandoned(const fs::path& path, const std::string& kernel) {
  const FileHandle folder = openFolder(path);
  if (!isAbandoned(path, folder, kernel)) return;
  // The handle is used, so that nothing is found elsewhere.
  const fs::path within = fs::path("/proc/self/fd") / std::to_string(folder.get());
  if (removeContent(within) && ::unlinkat(folder.get(), kClaim, 0) == 0) ::rmdir(path.c_str());
}

}  // namespace

FileHandle claimFolder(const fs::path& folder) {
  FileHandle handle = openFolder(folder);
  const std::string kernel = kernelStart();
  if (kernel.empty() || !handle || !lock(handle)) return FileHandle();
  const FileHandle file(::openat(handle.get(), kClaim, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  // Half a number is none of a kernel's, so a failure here only means that the folder stays.
  if (!file || ::write(file.get(), kernel.data(), kernel.size()) < 0) return FileHandle();
  return handle;
}

void removeClaimedFolder(const fs::path& folder) {
  std::error_code ignored;
  removeContent(folder);
  fs::remove_all(folder, ignored);
}

void removeAbandonedFolders(const fs::path& place) noexcept {
  try {
    const std::string kernel = kernelStart();
    if (kernel.empty()) return;
    std::error_code ignored;
    for (fs::directory_iterator entry(place, ignored), end; !ignored && entry != end; entry.increment(ignored))
      if (isNamedAsOurs(entry->path().filename().native())) removeIfAbandoned(entry->path(), kernel);
  } catch (const std::exception&) {  // out of memory: the next start removes them
  }
}

}  // namespace poinsot::app
