// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene_file.h"

namespace poinsot::stage {

/// A scene from a few lines of its file.
inline scene::Scene sample(const std::string& extra = "") {
  return scene::parseScene("[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1, 0.5, 1.6]\n" + extra,
                           "sample.toml");
}

}  // namespace poinsot::stage
