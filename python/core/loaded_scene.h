// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/scene_request.h"

namespace poinsot::python {

/// A scene that was read, with what it was read from.
class LoadedScene {
 public:
  using Words = std::vector<std::string>;

  /// @param limits  as after --limit, above those of the user's limits.toml.
  /// @throws core::Error as app::readSceneRequest() and app::loadRequested().
  static LoadedScene ofFile(const std::string& fileName, Words overrides, const Words& limits,
                            const Words& assetRoots);
  /// @param fileName  for messages; its folder is where files that the scene names lie.
  static LoadedScene ofText(std::string text, const std::string& fileName, Words overrides, const Words& limits,
                            const Words& assetRoots);

  const app::SceneRequest& request() const { return request_; }
  const scene::Scene& scene() const { return scene_; }
  const scene::Limits& limits() const { return request_.allowance.limits; }
  /// Different for each one there ever was in this process.
  std::uint64_t number() const { return number_; }
  std::int64_t frameCount() const;
  /// Film times to motion times, s.
  std::vector<double> motionTimes_s(const std::vector<double>& filmTimes_s) const;

 private:
  explicit LoadedScene(app::SceneRequest request);

  app::SceneRequest request_;
  scene::Scene scene_;
  std::uint64_t number_;
};

}  // namespace poinsot::python
