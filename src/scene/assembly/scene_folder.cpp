// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

#include "core/open_beneath.h"
#include "core/regular_file.h"
#include "core/text.h"

namespace poinsot::scene {
namespace {

using core::ErrorKind;

[[noreturn]] void refuseFile(ErrorKind kind, const std::string& path, const std::string& why) {
  throw core::Error(kind, fmt::format("cannot read {}: {}", core::printable(path), why));
}

[[noreturn]] void refuseFile(const std::string& path, const std::string& why) {
  refuseFile(ErrorKind::kScene, path, why);
}

std::string reason(int error) {
  if (error == ELOOP)
    return "it is a symbolic link, or is reached through one; a scene may name regular files only";
  if (error == EXDEV) return "it does not lie in the scene's folder or below it";
  if (error == EISDIR) return "it is a directory";
  if (error == EINVAL) return "it is not a regular file";
  return core::systemReason(error);
}

bool isAddress(std::string path) {
  std::ranges::transform(path, path.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return path.starts_with("file:") || path.find("://") != std::string::npos;
}

/// Rejects an empty name, a URL, and a name that a shell would expand, such as "~/mesh.stl".
void expectPlain(const std::string& path) {
  if (path.empty()) refuseFile(path, "the name is empty");
  if (std::ranges::any_of(path, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }))
    refuseFile(path, "a file name must not contain control characters");
  if (isAddress(path)) refuseFile(path, "it is a URL; give a path relative to the scene's folder");
  if (path.front() == '~' || path.find_first_of("$`") != std::string::npos)
    refuseFile(path, "file names are not expanded: a name must not begin with ~ or contain $ or `");
}

void expectBeneath(const std::filesystem::path& path) {
  if (path.is_absolute()) refuseFile(path, "the path must be relative to the scene's folder");
  for (const auto& part : path)
    if (part == "..") refuseFile(path, "the file must lie in the scene's folder or below it, without \"..\"");
}

/// Opens the file in the first folder of `roots` that contains it.
/// @param place  receives the path of the opened file
core::FileHandle openIn(const std::vector<std::filesystem::path>& roots, const std::filesystem::path& path,
                        std::filesystem::path& place) {
  int why = ENOENT;
  for (const auto& root : roots) {
    auto file = core::openBeneath(root, path);
    place = root / path;
    if (file) return file;
    if (why == ENOENT) why = errno;
    if (errno != ENOENT && errno != ENOTDIR) break;  // the file exists, but cannot be opened
  }
  const char* const others = roots.size() > 1 ? ", nor in a folder of --asset-root" : "";
  refuseFile(path, why == ENOENT ? reason(why) + " in the scene's folder" + others : reason(why));
}

}  // namespace

SceneFolder::SceneFolder(std::filesystem::path folder, Allowance allowance)
    : roots_{std::move(folder)}, limits_(allowance.limits) {
  roots_.insert(roots_.end(), allowance.assetRoots.begin(), allowance.assetRoots.end());
}

std::string SceneFolder::read(const std::string& relativePath) const {
  expectPlain(relativePath);
  expectBeneath(relativePath);
  InputFile input{relativePath, {}, {}};
  const core::FileHandle file = openIn(roots_, relativePath, input.place);
  const std::size_t rest = limits_.bytes(Limit::kFilesBytes) - bytes_;
  const bool isLast = rest < limits_.bytes(Limit::kFileBytes);  // rest is less than one file may have
  const Limit limit = isLast ? Limit::kFilesBytes : Limit::kFileBytes;
  std::string text;
  try {
    text = core::allBytesOf(file, isLast ? rest : limits_.bytes(limit), ErrorKind::kScene);
  } catch (const core::Error& error) {
    if (error.kind() != ErrorKind::kLimit) refuseFile(relativePath, error.message());
    refuseFile(
        ErrorKind::kLimit, relativePath,
        fmt::format("{}; {}{}", error.message(),
                    isLast ? "together the files of the scene exceed their limit; " : "", howToRaise(limit)));
  }
  bytes_ += text.size();
  input.digest = core::sha256(text);
  read_.push_back(std::move(input));
  return text;
}

geometry::MeshReading SceneFolder::readMesh(const std::string& relativePath) const {
  const auto format = geometry::meshFormatOf(relativePath);  // before read(), so that only meshes are read
  const std::string bytes = read(relativePath);
  const std::size_t most = limits_.bytes(Limit::kTriangles);
  try {
    geometry::MeshReading reading =
        geometry::parseMesh(bytes, format, relativePath, {bytes.size(), most - triangles_});
    triangles_ += reading.mesh.triangles.size();
    return reading;
  } catch (const core::Error& error) {
    if (error.kind() != ErrorKind::kLimit) throw;
    throw core::Error(ErrorKind::kLimit,
                      fmt::format("{}; the meshes of a scene may have {} triangles in all; {}", error.message(),
                                  most, howToRaise(Limit::kTriangles)),
                      error.where());
  }
}

}  // namespace poinsot::scene
