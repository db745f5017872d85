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

/// Size and margins of the panel that a view is composed for.
struct PanelFrame {
  glm::ivec2 size_px{1, 1};
  double type_px = 1;  ///< reference size of type, as in Sizing (lettering.h)
  double line_px = 2;
  double least_px = 0;  ///< smallest size of a label
  Margins margins;
  double heading_px = 0;        ///< height at the top that labels avoid
  std::vector<PixelBox> taken;  ///< boxes that labels avoid, from the panel's corner
  double mostUnit_px = std::numeric_limits<double>::infinity();  ///< limit on the scale, as in frameAll()
};

/// Composer of the draw lists of one view. The constructor computes everything that does not depend on time
/// (scales, framing, whole curves); compose() is a pure function of the moment.
class ViewStage {
 public:
  /// @param scene  scene whose camera and shown objects are the view's
  /// @param motion  of the scene (picture_motion.h), shared by all views
  /// @throws core::Error(kPhysics) if the view shows something that the motion does not have.
  ViewStage(scene::Scene scene, std::shared_ptr<const physics::Motion> motion);
  ~ViewStage();
  ViewStage(ViewStage&&) noexcept;

  draw::DrawList compose(const Moment& moment, const PanelFrame& frame) const;

  /// Returns the largest possible pixels per metre of the body in this frame. Ignores the frame's mostUnit_px.
  double metre_px(const PanelFrame& frame) const;
  /// Returns picture lengths per metre of the body.
  double bodyScale() const;
  /// Returns how many times larger than the body the path of its flight is drawn; 1 if the body does not fly.
  double flightScale() const;

  /// Returns seconds of motion per second of film.
  double speed() const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
