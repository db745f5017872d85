// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/mesh_file.h"
#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Folder of a scene. A scene comes from anywhere, so it may read only regular files in this folder or below: no
/// absolute path, no "..", no symbolic link, and no more bytes than the user allows. Files that are missing here
/// are searched under the same rules in the asset roots, which the user names.
class SceneFolder {
 public:
  explicit SceneFolder(std::filesystem::path folder, Allowance allowance = {});

  /// Reads a whole file.
  /// @throws core::Error(kScene) if the path is not allowed or the file is missing; (kLimit) if the file is too
  /// large, by itself or together with those read before.
  std::string read(const std::string& relativePath) const;

  /// Reads a mesh and the notes on its file.
  /// @throws as read() and parseMesh(); core::Error(kLimit) also for too many triangles in all meshes together.
  geometry::MeshReading readMesh(const std::string& relativePath) const;

  const std::vector<InputFile>& filesRead() const { return read_; }

 private:
  /// Record of the files read; the only state that reading changes.
  mutable std::vector<InputFile> read_;
  mutable std::size_t bytes_ = 0, triangles_ = 0;

  std::vector<std::filesystem::path> roots_;  ///< in search order
  Limits limits_;
};

}  // namespace poinsot::scene
