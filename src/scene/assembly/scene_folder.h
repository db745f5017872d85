// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/mesh_file.h"
#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// The folder a scene is in. A scene comes from anywhere, so it reaches only regular files there and below: no
/// absolute path, no "..", no symbolic link, and so much of them as the user allows. What is not there is looked
/// for likewise in the asset roots, which the user names.
class SceneFolder {
 public:
  explicit SceneFolder(std::filesystem::path folder, Allowance allowance = {});

  /// All of a file.
  /// @throws core::Error(kScene) with the reason: where it may not lie, or that it is missing; (kLimit) if it is
  /// too large, by itself or with those read before.
  std::string read(const std::string& relativePath) const;

  /// Reads a mesh and the notes on its file. @throws as read() and parseMesh(); core::Error(kLimit) also for too
  /// many triangles in all meshes together.
  geometry::MeshReading readMesh(const std::string& relativePath) const;

  /// What was read so far, in that order.
  const std::vector<InputFile>& filesRead() const { return read_; }

 private:
  /// A note of what was done; reading changes nothing else.
  mutable std::vector<InputFile> read_;
  mutable std::size_t bytes_ = 0, triangles_ = 0;

  std::vector<std::filesystem::path> roots_;  ///< in the order of search
  Limits limits_;
};

}  // namespace poinsot::scene
