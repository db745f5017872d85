// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene_file.h"
#include "stage/stage.h"

namespace poinsot::stage {

/// Returns a simple scene, with `extra` lines of a scene file.
inline scene::Scene sample(const std::string& extra = "") {
  return scene::parseScene("[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1, 0.5, 1.6]\n" + extra,
                           "sample.toml");
}

/// Returns the draw list of a picture of one view.
inline draw::DrawList onlyList(const Stage& stage, const Moment& moment, glm::ivec2 size_px) {
  return stage.compose(moment, size_px).panels.at(0).list;
}

}  // namespace poinsot::stage
