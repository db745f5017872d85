// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_folder.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "core/regular_file.h"
#include "core/text.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw core::Error(core::ErrorKind::kScene, fmt::format("cannot read {}: {}", core::printable(path), why));
}

std::string reason(int error) {
  if (error == ELOOP) return "it is a symbolic link, or lies behind one; a scene names regular files";
  return std::generic_category().message(error);
}

void expectBeneath(const std::filesystem::path& path) {
  if (path.empty()) refuse(path, "the name is empty");
  if (path.is_absolute()) refuse(path, "the path must be relative to the scene's folder");
  for (const auto& part : path)
    if (part == "..") refuse(path, "the file must lie in the scene's folder or below it, without \"..\"");
}

/// Folder by folder, so that no link on the way leads elsewhere. O_NONBLOCK: opening a FIFO must not wait.
core::FileHandle openBeneath(const std::filesystem::path& folder, const std::filesystem::path& path) {
  core::FileHandle at(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY));
  for (const auto& part : path) {
    if (!at) refuse(path, reason(errno));
    at = core::FileHandle(::openat(at.get(), part.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW));
  }
  if (!at) refuse(path, reason(errno));
  return at;
}

}  // namespace

std::string SceneFolder::read(const std::string& relativePath) const {
  const std::filesystem::path path(relativePath);
  expectBeneath(path);
  const core::FileHandle file = openBeneath(folder_, path);
  std::string text;
  try {
    text = core::bytesOf(file, kMostFileBytes, core::ErrorKind::kScene);
  } catch (const core::Error& error) {
    refuse(path, error.message());
  }
  if (text.size() > kMostFileBytes) refuse(path, fmt::format("it has more than {} MiB", kMostFileBytes >> 20));
  read_.push_back({relativePath, core::sha256(text)});
  return text;
}

}  // namespace poinsot::scene
