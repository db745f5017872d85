// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "draw/draw_list.h"
#include "physics/motion.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// Turns one view of a scene into draw lists. Everything that does not depend on time (scales, framing, whole
/// curves) is worked out once, here; compose() is a pure function of the film time.
class ViewStage {
 public:
  /// `scene`: its camera and what it shows are the view's. `motion`: of the scene (picture_motion.h), shared by
  /// its views.
  /// @throws core::Error(kPhysics) where the view asks for something the motion does not have.
  ViewStage(scene::Scene scene, std::shared_ptr<const physics::Motion> motion);
  ~ViewStage();
  ViewStage(ViewStage&&) noexcept;

  /// What the view shows at film time `filmTime_s`, in a panel of `size_px` (width, height).
  draw::DrawList compose(double filmTime_s, glm::ivec2 size_px) const;

  /// Motion seconds per film second.
  double speed() const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
