// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_cache.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__x86_64__)
#include <cpuid.h>
#endif

#include <array>
#include <cerrno>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "core/sha256.h"

namespace poinsot::gl {
namespace {

namespace fs = std::filesystem;

std::string_view setting(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Returns the folder for caches, or an empty path. Relative paths are ignored (XDG base directories).
fs::path cacheHome() {
  if (const auto own = setting("POINSOT_CACHE"); !own.empty()) return own.starts_with('/') ? own : fs::path();
  if (const auto xdg = setting("XDG_CACHE_HOME"); xdg.starts_with('/')) return fs::path(xdg) / "poinsot";
  if (const auto home = setting("HOME"); home.starts_with('/')) return fs::path(home) / ".cache" / "poinsot";
  return {};
}

/// Returns the family, model and features of the CPU. Compiled shaders depend on the model, but the key of Mesa's
/// cache contains only most of the features.
std::array<unsigned, 6> processor() {
  std::array<unsigned, 6> facts{};
#if defined(__x86_64__)
  unsigned unused = 0;
  // EBX of leaf 1 is left out, because it contains the number of the current core.
  __get_cpuid(1, &facts[0], &unused, &facts[1], &facts[2]);
  __get_cpuid_count(7, 0, &unused, &facts[3], &facts[4], &facts[5]);
#endif
  return facts;
}

std::string folderName(bool reproducible) {
  core::Sha256 hash;
  hash.add(reproducible ? "reproducible" : "native");
  const auto facts = processor();
  hash.add(std::as_bytes(std::span<const unsigned>(facts)));
  return "shaders-" + core::toHex(hash.finish()).substr(0, 12);
}

/// Creates a folder and missing parents. Returns false if the folder or its first existing parent belongs to
/// another user, which can happen because sudo keeps HOME.
bool make(const fs::path& folder) {
  struct stat facts {};
  if (::stat(folder.c_str(), &facts) == 0) return facts.st_uid == ::geteuid();
  if (folder == folder.root_path() || !make(folder.parent_path())) return false;
  return ::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST;
}

bool isOursAlone(const struct stat& facts) {
  return facts.st_uid == ::geteuid() && (facts.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// Reports whether the path is a folder that only this user owns and may write to.
/// @param flags  AT_SYMLINK_NOFOLLOW to reject symbolic links, 0 to follow them
bool isFolderOfOursAlone(const fs::path& folder, int flags) {
  struct stat facts {};
  return ::fstatat(AT_FDCWD, folder.c_str(), &facts, flags) == 0 && S_ISDIR(facts.st_mode) && isOursAlone(facts) &&
         ::access(folder.c_str(), R_OK | W_OK | X_OK) == 0;
}

/// Reports whether only this user owns and may write to everything in the folder. Entries that vanish during the
/// check are ignored, because other processes may use the cache.
bool holdsOurOwnOnly(const fs::path& folder) {
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    struct stat facts {};
    if (::lstat(entry->path().c_str(), &facts) != 0) continue;
    if (!(S_ISDIR(facts.st_mode) || S_ISREG(facts.st_mode)) || !isOursAlone(facts)) return false;
  }
  return !failure || failure == std::errc::no_such_file_or_directory;
}

}  // namespace

bool isShaderCacheOff() { return setting("POINSOT_CACHE") == "off"; }

fs::path shaderCacheFolder(bool reproducible) {
  const fs::path home = cacheHome();
  if (home.empty()) return {};
  fs::path folder = home / folderName(reproducible);
  const bool safe = make(folder) && isFolderOfOursAlone(home, 0) &&
                    isFolderOfOursAlone(folder, AT_SYMLINK_NOFOLLOW) && holdsOurOwnOnly(folder);
  return safe ? folder : fs::path();
}

}  // namespace poinsot::gl
