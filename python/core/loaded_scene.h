// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "motions.h"
#include "request/requested_scene.h"
#include "scene/motion/film_clock.h"

namespace poinsot::python {

/// A scene that was read, with what it was read from.
class LoadedScene {
 public:
  using Words = std::vector<std::string>;

  /// @param limits  as after --limit.
  /// @throws core::Error as request::readSceneRequest() and request::requestedScene().
  static LoadedScene ofFile(const std::string& fileName, Words overrides, const Words& limits,
                            const Words& assetRoots);
  /// @param fileName  for messages; its folder is where files that the scene names lie.
  static LoadedScene ofText(std::string text, const std::string& fileName, Words overrides, const Words& limits,
                            const Words& assetRoots);

  const request::RequestedScene& requested() const { return requested_; }
  const request::SceneRequest& request() const { return requested_.request; }
  const scene::Scene& scene() const { return requested_.scene; }
  const scene::Limits& limits() const { return request().allowance.limits; }
  /// Different for each scene of this process.
  std::uint64_t number() const { return number_; }
  std::int64_t frameCount() const;
  /// From film times to motion times, s. @pre the film times are from 0 to the film's duration.
  scene::FilmClock clock() const;
  /// The scene's motion, as Motions::over().
  std::shared_ptr<const physics::Motion> motionOver(double from_s, double to_s) const {
    return motions_->over(scene(), from_s, to_s);
  }

 private:
  explicit LoadedScene(request::SceneRequest request);

  request::RequestedScene requested_;
  std::uint64_t number_;
  std::unique_ptr<Motions> motions_ = std::make_unique<Motions>();
};

}  // namespace poinsot::python
