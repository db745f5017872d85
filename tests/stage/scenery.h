// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/scene_file.h"
#include "stage/figures/actor.h"
#include "stage/figures/actors.h"

namespace poinsot::stage {

/// Inputs that the actors of a scene are made from, without pictures.
struct Scenery {
  scene::Scene scene;
  PictureMotion motion;
  BodyFigure body;
  Scales scales;
  std::optional<Construction> construction;
  Setting setting;

  explicit Scenery(const std::string& text, const Eigen::Vector3d& axisLengths = Eigen::Vector3d::Ones())
      : scene(scene::parseScene(text, "sample.toml")),
        motion(scene, drawnMotion(scene)),
        body(scene),
        scales(makeScales(scene, motion, body)),
        construction(showsConstruction(scene.show, motion) ? std::optional(Construction(motion, scales))
                                                           : std::nullopt),
        setting{scene, motion, body, scales, construction ? &*construction : nullptr, axisLengths} {}
  Scenery(const Scenery&) = delete;  // setting refers to the other members
};

}  // namespace poinsot::stage
