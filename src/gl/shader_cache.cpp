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

/// Returns the folder for caches; empty if there is none. Relative paths are not used (XDG base directories).
fs::path cacheHome() {
  if (const auto own = setting("POINSOT_CACHE"); !own.empty()) return own.starts_with('/') ? own : fs::path();
  if (const auto xdg = setting("XDG_CACHE_HOME"); xdg.starts_with('/')) return fs::path(xdg) / "poinsot";
  if (const auto home = setting("HOME"); home.starts_with('/')) return fs::path(home) / ".cache" / "poinsot";
  return {};
}

/// Returns family, model and features of the CPU. Mesa's cache key has most features, but LLVM depends on the
/// model too.
std::array<unsigned, 6> processor() {
  std::array<unsigned, 6> facts{};
#if defined(__x86_64__)
  unsigned unused = 0;
  // EBX of leaf 1 is left out: it has the number of the current core.
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

/// Makes a folder and its parents, unless that would be in a folder of another user (sudo keeps HOME).
bool make(const fs::path& folder) {
  struct stat facts {};
  if (::stat(folder.c_str(), &facts) == 0) return facts.st_uid == ::geteuid();
  if (folder == folder.root_path() || !make(folder.parent_path())) return false;
  return ::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST;
}

bool isOursAlone(const struct stat& facts) {
  return facts.st_uid == ::geteuid() && (facts.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// Reports whether only this user may write to the folder. Symbolic links are no folders, unless `flags` follow
/// them.
bool isFolderOfOursAlone(const fs::path& folder, int flags) {
  struct stat facts {};
  return ::fstatat(AT_FDCWD, folder.c_str(), &facts, flags) == 0 && S_ISDIR(facts.st_mode) && isOursAlone(facts) &&
         ::access(folder.c_str(), R_OK | W_OK | X_OK) == 0;
}

/// Checks everything in the folder. Entries come and go while other processes use the cache.
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
