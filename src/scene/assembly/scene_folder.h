// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/mesh_file.h"
#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Folder of a scene, from which the scene may read files. A scene can come from an untrusted source. It may read
/// only regular files in this folder or below. Absolute paths, "..", symbolic links and more bytes than the user
/// allows are rejected. Files that are missing in this folder are searched in the asset roots, which the user
/// names, under the same rules.
class SceneFolder {
 public:
  explicit SceneFolder(std::filesystem::path folder, Allowance allowance = {});

  /// Reads a file completely.
  /// @throws core::Error(kScene) if the path is not allowed or the file is missing; core::Error(kLimit) if the
  /// file is too large, or if all files read so far are too large together.
  std::string read(const std::string& relativePath) const;

  /// Reads a mesh. Also returns notes about its file.
  /// @throws the errors of read() and of parseMesh(); core::Error(kLimit) if all meshes together have too many
  /// triangles.
  geometry::MeshReading readMesh(const std::string& relativePath) const;

  const std::vector<InputFile>& filesRead() const { return read_; }

 private:
  /// Files read so far. Mutable, because reading a file changes nothing else in the folder.
  mutable std::vector<InputFile> read_;
  mutable std::size_t bytes_ = 0, triangles_ = 0;

  std::vector<std::filesystem::path> roots_;  ///< folders to search for a file, in this order
  Limits limits_;
};

}  // namespace poinsot::scene
