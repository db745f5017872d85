// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "draw/draw_list.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Turns a scene into pictures-as-values. Everything that does not depend on time (scales, framing, whole curves)
/// is worked out once, here; compose() is a pure function of the film time.
class Stage {
 public:
  /// @throws core::Error(kPhysics) where the scene asks for something its motion does not have
  /// (the invariable plane of a body at rest).
  explicit Stage(scene::Scene scene);
  ~Stage();
  Stage(Stage&&) noexcept;

  /// What the picture shows at film time `filmTime_s`, for a picture of `size_px` (width, height).
  draw::DrawList compose(double filmTime_s, glm::ivec2 size_px) const;

  const scene::Scene& scene() const;
  /// Motion seconds per film second: the scene's, or the one chosen from |omega|.
  double speed() const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
