// SPDX-License-Identifier: Apache-2.0
#include "core/open_beneath.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <optional>

namespace poinsot::core {
namespace {

using std::filesystem::path;

// Opens without any side effect. O_NONBLOCK keeps open() from blocking if a pipe has replaced the file.
constexpr int kForReading = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | O_NOFOLLOW;
constexpr int kToLookAt = O_PATH | O_CLOEXEC | O_NOFOLLOW;

FileHandle failed(int reason) {
  errno = reason;
  return FileHandle();
}

/// Returns nullopt if the kernel lacks openat2, or if a sandbox forbids that call.
std::optional<FileHandle> openByTheKernel(int folder, const path& relative, int flags) {
  open_how how{};
  how.flags = static_cast<std::uint64_t>(flags);
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS | RESOLVE_NO_SYMLINKS;
  // Number of tries after EAGAIN: during a rename, the kernel cannot check that the path stays beneath the folder.
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    const auto fd = static_cast<int>(syscall(SYS_openat2, folder, relative.c_str(), &how, sizeof how));
    if (fd >= 0) return FileHandle(fd);
    if (errno == ENOSYS || errno == EPERM) return std::nullopt;
    if (errno != EAGAIN && errno != EINTR) break;
  }
  return FileHandle();
}

/// Returns whether the handle is a symbolic link. Handles opened with O_PATH and O_NOFOLLOW can be links.
bool isLink(const FileHandle& file) {
  struct stat status {};
  return file && fstat(file.get(), &status) == 0 && S_ISLNK(status.st_mode);
}

FileHandle openFolderByFolder(int folder, const path& relative, int flags) {
  FileHandle reached;
  int at = folder;
  for (auto part = relative.begin(); part != relative.end();) {
    if (*part == ".." || part->is_absolute()) return failed(EXDEV);
    const path name = *part;
    const bool last = ++part == relative.end();
    FileHandle next(openat(at, name.empty() ? "." : name.c_str(), last ? flags : kToLookAt));
    if (!next) return failed(errno);
    if (isLink(next)) return failed(ELOOP);
    reached = std::move(next);
    at = reached.get();
  }
  return reached;
}

int whyNot(const FileHandle& file) {
  struct stat status {};
  if (fstat(file.get(), &status) != 0) return errno;
  if (S_ISREG(status.st_mode)) return 0;
  if (S_ISLNK(status.st_mode)) return ELOOP;
  return S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
}

}  // namespace

FileHandle openBeneath(const path& folder, const path& relative, Following following) {
  const FileHandle root(open(folder.empty() ? "." : folder.c_str(), O_PATH | O_CLOEXEC | O_DIRECTORY));
  if (!root) return failed(errno);
  const auto opened = [&](int flags) {
    if (following == Following::kByTheKernel)
      if (auto file = openByTheKernel(root.get(), relative, flags)) return std::move(*file);
    return openFolderByFolder(root.get(), relative, flags);
  };
  const FileHandle seen = opened(kToLookAt);
  if (!seen) return failed(errno);
  if (const int reason = whyNot(seen)) return failed(reason);
  FileHandle file = opened(kForReading);  // may be another file now, so its kind is checked again
  if (!file) return failed(errno);
  const int reason = whyNot(file);
  return reason == 0 ? std::move(file) : failed(reason);
}

}  // namespace poinsot::core
