// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "draw/draw_list.h"
#include "physics/motion.h"
#include "scene/scene.h"
#include "stage/framing.h"
#include "stage/moment.h"
#include "stage/type/pixel_box.h"

namespace poinsot::stage {

/// What a view is composed for.
struct PanelFrame {
  glm::ivec2 size_px{1, 1};  ///< width, height
  double type_px = 1;        ///< what type is sized by, as Sizing (lettering.h)
  double line_px = 2;        ///< width of an ordinary line
  double least_px = 0;       ///< no label is smaller
  Margins margins;
  double heading_px = 0;        ///< at the top, where no label goes
  std::vector<PixelBox> taken;  ///< from the panel's corner: where no label goes either
  double mostUnit_px = std::numeric_limits<double>::infinity();  ///< as in frameAll()
};

/// Turns one view of a scene into draw lists. Everything that does not depend on time (scales, framing, whole
/// curves) is worked out once, here; compose() is a pure function of the moment.
class ViewStage {
 public:
  /// `scene`: its camera and what it shows are the view's. `motion`: of the scene (picture_motion.h), shared by
  /// its views.
  /// @throws core::Error(kPhysics) where the view asks for something the motion does not have.
  ViewStage(scene::Scene scene, std::shared_ptr<const physics::Motion> motion);
  ~ViewStage();
  ViewStage(ViewStage&&) noexcept;

  /// What the view shows at a moment.
  draw::DrawList compose(const Moment& moment, const PanelFrame& frame) const;

  /// Pixels that a metre of the body would have at most in this frame; its mostUnit_px does not count.
  double metre_px(const PanelFrame& frame) const;
  /// Picture lengths per metre of the body.
  double bodyScale() const;
  /// How many times as large as the body the path of its flight is drawn; 1 where it does not fly.
  double flightScale() const;

  /// Motion seconds per film second.
  double speed() const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
