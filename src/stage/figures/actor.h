// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "stage/body/body_figure.h"
#include "stage/figures/construction.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"
#include "stage/type/label_layout.h"

namespace poinsot::stage {

/// Amount of glass at the near side, the far side and the rim of a hollow object, in sheets.
struct GlassShares {
  double near = 1, far = 1, rim = 1;
};

/// Gap between a place and its label, as a share of the label's size.
inline constexpr double kLabelGap = 0.35;

/// Target that actors draw on, for one picture: coordinates in V, lengths in picture units. The camera of `list`
/// is set.
struct Canvas {
  draw::DrawList& list;
  std::vector<Label>& labels;
  const Palette& colors;
  const scene::LabelTexts& names;
  double line_px = 2;
  double thickness = 1;  ///< factor on the radii of arrows and tubes
  double type_px = 32;   ///< size of an ordinary label; 0: no labels
  double least_px = 0;
  bool still = false;  ///< no label is faint: each is shown or absent

  /// Adds a flat line.
  /// @param width  in ordinary lines
  /// @param lift  distance towards the eye
  void line(const std::vector<Eigen::Vector3d>& points_V, bool closed, const draw::Color& color, double width = 1,
            double lift = 0.004) const;
  /// Adds a straight dashed line that begins and ends with a dash.
  void dashes(const Eigen::Vector3d& from_V, const Eigen::Vector3d& to_V, const draw::Color& color,
              double width = 1) const;
  /// Adds an arrow from the origin, with a shaft of the given radius.
  void arrow(const Eigen::Vector3d& tip_V, double radius, const draw::Color& color) const;
  void dot(const Eigen::Vector3d& at_V, double radius, const draw::Color& color) const;
  void tube(const std::vector<Eigen::Vector3d>& points_V, bool closed, double radius,
            const draw::Color& color) const;
  /// Adds a hollow ellipsoid about the origin. `shares` is the thickness of its sides and rim, in sheets of that
  /// opacity.
  draw::GlassEllipsoid& glassEllipsoid(const Eigen::Matrix3d& semiAxes_V, const draw::Color& color, double opacity,
                                       const GlassShares& shares) const;
  /// Returns the opacity of glass that is `share` times as thick as a sheet of the given opacity, and thinner on
  /// dark paper. An opacity of 1 is always opaque.
  float glass(double opacity, double share = 1) const;
  void arrowFrom(const Eigen::Vector3d& from_V, const Eigen::Vector3d& tip_V, double radius,
                 const draw::Color& color) const;
  /// Adds a label beside a point, on the side away from the picture of `inside_V`.
  void label(const std::string& tex, const Eigen::Vector3d& at_V, const Eigen::Vector3d& inside_V,
             const draw::Color& color, double size = 1) const;
  /// Adds a label beside a place of the picture. In a still, a label with an opacity below 0.5 is left out, and
  /// any other is opaque.
  /// @param size  in ordinary labels
  /// @param gap  as a share of the label's size
  void labelAt(const std::string& tex, glm::vec2 at_px, glm::vec2 direction, const draw::Color& color,
               double size = 1, double gap = kLabelGap, float opacity = 1) const;
  void label(scene::LabelName name, const Eigen::Vector3d& at_V, const Eigen::Vector3d& inside_V,
             const draw::Color& color, double size = 1) const {
    label(names[name], at_V, inside_V, color, size);
  }
  void labelAt(scene::LabelName name, glm::vec2 at_px, glm::vec2 direction, const draw::Color& color,
               double size = 1, double gap = kLabelGap, float opacity = 1) const {
    labelAt(names[name], at_px, direction, color, size, gap, opacity);
  }
  /// Returns the pixel where the camera sees a point. A point behind the eye counts as beside the eye, far outside
  /// the picture.
  glm::vec2 at_px(const Eigen::Vector3d& at_V) const;
};

/// Mixes two colours in linear light; `share` is the part of `color`.
draw::Color mixed(const draw::Color& color, const draw::Color& over, double share);

/// Returns a circle around `centre_V`, across the unit vector `axis_V`.
std::vector<Eigen::Vector3d> circleAbout(const Eigen::Vector3d& centre_V, const Eigen::Vector3d& axis_V,
                                         double radius, int points);

/// Returns a unit vector across a unit vector: `hint` without its part along `axis`, or a fallback direction if
/// that part leaves little.
Eigen::Vector3d across(const Eigen::Vector3d& axis, const Eigen::Vector3d& hint);

/// Inputs of an actor's constructor, for one view of a scene. `motion`, `body` and `construction` outlive the
/// actors.
struct Setting {
  const scene::Scene& scene;
  const PictureMotion& motion;
  const BodyFigure& body;
  const Scales& scales;
  const Construction* construction;  ///< null if no part of it is shown
  Eigen::Vector3d axisLengths;       ///< drawn lengths of the principal axes
};

/// Object drawn in a view. The drawing is a pure function of the scene, the time and the state.
class Actor {
 public:
  virtual ~Actor() = default;

  virtual void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const = 0;
  /// Returns the points, in V, that the frame must hold at that instant.
  virtual std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const = 0;
  /// Returns the radius of a ball about the origin that the frame must hold too; 0: no ball.
  virtual double ballRadius() const { return 0; }
  /// Returns the point, in V, out of which the object's solids grow when they appear (presence.h).
  virtual Eigen::Vector3d growsFrom(const PictureState& /*state*/) const { return Eigen::Vector3d::Zero(); }
};

}  // namespace poinsot::stage
