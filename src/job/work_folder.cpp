// SPDX-License-Identifier: Apache-2.0
#include "job/work_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "core/atomic_file.h"
#include "core/file_error.h"
#include "core/sha256.h"
#include "core/text.h"

namespace poinsot::job {
namespace {

[[noreturn]] void fail(const std::filesystem::path& folder, const std::string& why, int code) {
  throw core::FileError(core::ErrorKind::kIo, fmt::format("{}: {}", core::printable(folder.string()), why), folder,
                        code);
}

[[noreturn]] void failWithErrno(const std::filesystem::path& folder) {
  const int code = errno;
  fail(folder, core::systemReason(code), code);
}

/// Returns whether `folder` is still the name of the opened folder. A previous owner of the lock may have removed
/// it.
bool stillThere(int fd, const std::filesystem::path& folder) {
  struct stat opened {
  }, named{};
  return fstat(fd, &opened) == 0 && lstat(folder.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

core::FileHandle openLocked(const std::filesystem::path& folder, WorkFolderUse use) {
  const int lock = use == WorkFolderUse::kShared ? LOCK_SH : LOCK_EX;
  for (;;) {
    if (mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST) failWithErrno(folder);
    core::FileHandle handle(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!handle && errno == ENOENT) continue;
    if (!handle) failWithErrno(folder);
    if (flock(handle.get(), lock | LOCK_NB) != 0)
      fail(folder, "another poinsot is making this output now: wait for it, or choose another output with -o",
           EWOULDBLOCK);
    if (stillThere(handle.get(), folder)) return handle;
  }
}

/// Shortens a file name so that the name of its work folder has at most 255 bytes. Adds a digest, so that
/// different names stay different.
std::string shortEnough(const std::string& name) {
  constexpr std::size_t kMost = 255 - std::string_view("..poinsot").size(), kKept = 200;
  if (name.size() <= kMost) return name;
  return name.substr(0, kKept) + '-' + core::toHex(core::sha256(name)).substr(0, 16);
}

}  // namespace

std::filesystem::path workFolderOf(const std::filesystem::path& target) {
  return core::folderOf(target) / ("." + shortEnough(target.filename().string()) + ".poinsot");
}

WorkFolder::WorkFolder(const std::filesystem::path& target, WorkFolderUse use)
    : path_(workFolderOf(target)), lock_(openLocked(path_, use)), shared_(use == WorkFolderUse::kShared) {
  if (use == WorkFolderUse::kFresh) removeContents();
}

WorkFolder::~WorkFolder() {
  try {
    leave();
  } catch (const std::bad_alloc&) {
    // Leaves the folder to the next render, which reuses or removes it.
  }
}

void WorkFolder::leave() const {
  if (!discarded_ && (shared_ || holdsSegments())) return;  // another shard may have just started
  removeContents();
  std::error_code ignored;  // ignored: removal fails if the folder contains other files, which must stay
  std::filesystem::remove(path_, ignored);
}

bool WorkFolder::holdsSegments() const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(path_, ignored))
    if (entry.path().filename().string().starts_with("segment-")) return true;
  return false;
}

// Removes job.json, the segments, and the files named *.tmp, which a killed process may have left.
void WorkFolder::removeContents() const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(path_, ignored)) {
    const std::string name = entry.path().filename().string();
    const bool ours = name.starts_with("segment-") || name == "job.json" || name.ends_with(".tmp");
    if (ours) std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace poinsot::job
