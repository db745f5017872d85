// SPDX-License-Identifier: Apache-2.0
#include "output/target_check.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>

#include "core/atomic_file.h"
#include "core/file_error.h"
#include "core/shell_word.h"
#include "core/text.h"

namespace poinsot::output {
namespace {

/// @param code  errno that opening or creating the file would set.
[[noreturn]] void refuse(const std::filesystem::path& path, int code, std::string_view reason) {
  throw core::FileError(core::ErrorKind::kIo, fmt::format("{}: {}", core::printable(path.native()), reason), path,
                        code);
}

[[noreturn]] void refuseByErrno(const std::filesystem::path& path, std::string_view doing = "") {
  const int code = errno;
  refuse(path, code, fmt::format("{}{}", doing, std::strerror(code)));
}

void checkFolder(const std::filesystem::path& folder) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) < 0) {
    if (errno == ENOENT)
      refuse(folder, ENOENT,
             "no such folder; make it with: mkdir -p " + core::printable(core::shellWord(folder.native())));
    refuseByErrno(folder);
  }
  if (!S_ISDIR(status.st_mode)) refuse(folder, ENOTDIR, "not a folder");
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) < 0)
    refuseByErrno(folder, "cannot be written to: ");
}

std::string_view kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISLNK(mode)) return "a symbolic link";
  if (S_ISFIFO(mode)) return "a pipe";
  return "a device or socket";
}

std::string refusalOf(const FileKind& kind) {
  if (!kind.isOwn) return "already exists; --force replaces it";
  const std::string as = kind.name.empty() ? "" : " as " + kind.name;
  return fmt::format("exists and was not written by poinsot{}; --force replaces it", as);
}

void checkExisting(const std::filesystem::path& target, bool force, const FileKind& kind) {
  struct stat status {};
  if (::lstat(target.c_str(), &status) < 0) {
    if (errno == ENOENT) return;
    refuseByErrno(target);
  }
  if (!S_ISREG(status.st_mode))
    refuse(target, S_ISDIR(status.st_mode) ? EISDIR : EEXIST,
           fmt::format("is {}; outputs are written to regular files", kindOf(status.st_mode)));
  if (!force && !(kind.isOwn && kind.isOwn(target))) refuse(target, EEXIST, refusalOf(kind));
}

void checkName(const std::filesystem::path& target) {
  const auto name = target.filename();
  if (name.empty() || name == "." || name == "..") refuse(target, EISDIR, "is a folder; name a file in it");
}

}  // namespace

void checkTarget(const std::filesystem::path& target, bool force, const FileKind& kind) {
  checkName(target);
  checkFolder(core::folderOf(target));
  checkExisting(target, force, kind);
}

void checkTargetInNewFolder(const std::filesystem::path& target, bool force, const FileKind& kind) {
  checkName(target);
  std::filesystem::path folder = core::folderOf(target);
  struct stat status {};
  while (::stat(folder.c_str(), &status) < 0 && errno == ENOENT && folder != core::folderOf(folder))
    folder = core::folderOf(folder);
  checkFolder(folder);
  if (folder == core::folderOf(target)) checkExisting(target, force, kind);
}

void checkAddedTo(const std::filesystem::path& target, bool force, const FileKind& kind) {
  checkName(target);
  struct stat status {};
  if (::stat(target.c_str(), &status) < 0) return checkFolder(core::folderOf(target));
  if (!S_ISREG(status.st_mode))
    refuse(target, S_ISDIR(status.st_mode) ? EISDIR : EEXIST,
           fmt::format("is {}; text is added to regular files", kindOf(status.st_mode)));
  if (!force && status.st_size > 0 && !kind.isOwn(target))
    refuse(target, EEXIST, fmt::format("exists and is not {}; --force adds to it", kind.name));
  if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) < 0) refuseByErrno(target, "cannot be added to: ");
}

void checkSequence(const FramePattern& pattern, std::int64_t first, std::int64_t last, bool force) {
  const auto folder = core::folderOf(pattern.path(first));
  struct stat status {};
  if (::lstat(folder.c_str(), &status) < 0 && errno == ENOENT) return checkFolder(core::folderOf(folder));
  checkFolder(folder);
  for (std::int64_t k = first; k <= last; ++k) checkExisting(pattern.path(k), force, drawnKind());
}

}  // namespace poinsot::output
