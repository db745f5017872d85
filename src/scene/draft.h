// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "scene/scene.h"

namespace poinsot::scene {

/// A scene while its keys are being read: what is final goes straight into `scene`, what several keys decide
/// together waits here for assemble.h.
struct Draft {
  Scene scene;
  std::optional<Eigen::Vector3d> moments, omega_B;
  std::optional<ShapeKind> shape, drawnShape;
  std::optional<Eigen::Vector3d> size_m, drawnSize;
  std::optional<double> mass_kg;
  int quality = 0;  ///< index into qualityPresets()
  std::optional<Eigen::Vector2i> size_px;
  std::optional<int> crf;
};

}  // namespace poinsot::scene
