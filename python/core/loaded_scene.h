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

/// Scene, with the request from which it was read.
class LoadedScene {
 public:
  using Words = std::vector<std::string>;

  /// Reads a scene from a file. @param limits  words of --limit.
  /// @throws core::Error as request::readSceneRequest() and request::requestedScene().
  static LoadedScene ofFile(const std::string& fileName, Words overrides, const Words& limits,
                            const Words& assetRoots);
  /// Reads a scene from a text. @param fileName  for messages; files that the scene names are in its folder.
  static LoadedScene ofText(std::string text, const std::string& fileName, Words overrides, const Words& limits,
                            const Words& assetRoots);

  const request::RequestedScene& requested() const { return requested_; }
  const request::SceneRequest& request() const { return requested_.request; }
  const scene::Scene& scene() const { return requested_.scene; }
  const scene::Limits& limits() const { return request().allowance.limits; }
  /// Returns a number that differs for each scene of this process.
  std::uint64_t number() const { return number_; }
  std::int64_t frameCount() const;
  /// Returns the clock that maps film times to motion times, s. @pre the film times are from 0 to the film's
  /// duration.
  scene::FilmClock clock() const;
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
