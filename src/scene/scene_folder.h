// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace poinsot::scene {

/// The folder a scene is in. A scene comes from anywhere, so it reaches only regular files there and below: no
/// absolute path, no "..", no symbolic link.
class SceneFolder {
 public:
  explicit SceneFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// All of a file.
  /// @throws core::Error(kScene) with the reason: where it may not lie, that it is missing, or too large.
  std::string read(const std::string& relativePath) const;

  /// What was read so far, in that order.
  const std::vector<InputFile>& filesRead() const { return read_; }

  /// The file's name for messages, as the scene's own.
  std::filesystem::path pathOf(const std::string& relativePath) const { return folder_ / relativePath; }

 private:
  std::filesystem::path folder_;
  mutable std::vector<InputFile> read_;  // a note of what was done; reading changes nothing else
};

}  // namespace poinsot::scene
