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
#include "stage/type/lettering.h"
#include "stage/type/pixel_box.h"

namespace poinsot::stage {

/// Size and margins of the panel for which a view is composed.
struct PanelFrame {
  glm::ivec2 size_px{1, 1};
  double type_px = 1;  ///< reference size of text; see Sizing in lettering.h
  double line_px = 2;
  double least_px = 0;  ///< smallest size of a label
  double arrowName = kArrowName;
  Margins margins;
  double heading_px = 0;        ///< height of the heading at the top, which labels avoid
  std::vector<PixelBox> taken;  ///< boxes that labels avoid, relative to the panel's top left corner
  double mostUnit_px = std::numeric_limits<double>::infinity();  ///< largest scale, see frameAll()
};

/// Composes the draw list of one view. The constructor computes everything that does not depend on time, such as
/// scales, framing and complete curves. compose() is a pure function of the moment.
class ViewStage {
 public:
  /// @param scene  scene whose camera and shown objects are those of the view
  /// @param motion  drawnMotion() of the scene (picture_motion.h), shared by all views
  /// @throws core::Error(kPhysics) if the view shows something that the motion does not have.
  ViewStage(scene::Scene scene, std::shared_ptr<const physics::Motion> motion);
  ~ViewStage();
  ViewStage(ViewStage&&) noexcept;

  draw::DrawList compose(const Moment& moment, const PanelFrame& frame) const;

  /// Returns the largest possible scale of the body in this frame, in pixels per metre. Ignores frame.mostUnit_px.
  double metre_px(const PanelFrame& frame) const;
  /// Returns the scale of the body, in picture lengths per metre.
  double bodyScale() const;
  /// Returns the scale of the flight's path relative to the scale of the body; 1 if the body does not fly.
  double flightScale() const;

  /// Returns seconds of motion per second of film.
  double speed() const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
