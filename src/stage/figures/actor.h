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
#include "stage/type/lettering.h"

namespace poinsot::stage {

/// Thickness of the glass of a hollow object at its near side, far side and rim, as multiples of one sheet.
struct GlassShares {
  double near = 1, far = 1, rim = 1;
};

/// Gap between a point and its label, as a fraction of the label's size.
inline constexpr double kLabelGap = 0.35;

/// Target that actors draw on, for one picture. Coordinates are in V, in picture lengths. The camera of `list` is
/// already set.
struct Canvas {
  draw::DrawList& list;
  std::vector<Label>& labels;
  const Palette& colors;
  const scene::LabelTexts& names;
  double line_px = 2;
  double thickness = 1;  ///< factor on the radii of arrows and tubes
  double type_px = 32;   ///< size of an ordinary label; 0: no labels
  double least_px = 0;
  double arrowName = kArrowName;
  bool still = false;  ///< labels are either opaque or absent, never faint

  /// Adds a flat line.
  /// @param width  width, as a multiple of the width of an ordinary line
  /// @param lift  distance by which the line is moved towards the eye, in picture lengths
  void line(const std::vector<Eigen::Vector3d>& points_V, bool closed, const draw::Color& color, double width = 1,
            double lift = 0.004) const;
  /// Adds a straight dashed line that begins and ends with a dash.
  /// @param lift  as for line(); a lift of the body's extent keeps a line inside the body visible
  void dashes(const Eigen::Vector3d& from_V, const Eigen::Vector3d& to_V, const draw::Color& color,
              double width = 1, double lift = 0.004) const;
  /// Adds an arrow from the origin, with a shaft of the given radius.
  void arrow(const Eigen::Vector3d& tip_V, double radius, const draw::Color& color) const;
  void dot(const Eigen::Vector3d& at_V, double radius, const draw::Color& color) const;
  void tube(const std::vector<Eigen::Vector3d>& points_V, bool closed, double radius,
            const draw::Color& color) const;
  /// Adds a hollow ellipsoid about the origin.
  /// @param opacity  opacity of one sheet of glass
  /// @param shares  thickness of its sides and rim, in sheets
  draw::GlassEllipsoid& glassEllipsoid(const Eigen::Matrix3d& semiAxes_V, const draw::Color& color, double opacity,
                                       const GlassShares& shares) const;
  /// Returns the opacity of glass that is `share` times as thick as a sheet with the given opacity. Glass on dark
  /// paper counts as thinner, unless its opacity is 1.
  float glass(double opacity, double share = 1) const;
  void arrowFrom(const Eigen::Vector3d& from_V, const Eigen::Vector3d& tip_V, double radius,
                 const draw::Color& color) const;
  /// Adds a label beside the point `at_V`, on the side that faces away from the point `inside_V` in the picture.
  void label(const std::string& tex, const Eigen::Vector3d& at_V, const Eigen::Vector3d& inside_V,
             const draw::Color& color, double size = 1) const;
  /// Adds a label beside a pixel. In a still, a label with an opacity below 0.5 is left out, and all other labels
  /// are opaque.
  /// @param size  size, as a multiple of the size of an ordinary label
  /// @param gap  gap between pixel and label, as a fraction of the label's size
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
  /// Names a point of the drawing, see draw::NamedPoint.
  void point(std::string name, const Eigen::Vector3d& at_V) const;
  /// Returns the pixel at which the camera sees a point. A point behind the eye is first moved forward to the
  /// camera's near plane, so its pixel is usually far outside the picture.
  glm::vec2 at_px(const Eigen::Vector3d& at_V) const;
};

/// Mixes two colours in linear light. `share` is the fraction of `color` in the result.
draw::Color mixed(const draw::Color& color, const draw::Color& over, double share);

/// Returns points on a circle around `centre_V`, in the plane perpendicular to the unit vector `axis_V`.
std::vector<Eigen::Vector3d> circleAbout(const Eigen::Vector3d& centre_V, const Eigen::Vector3d& axis_V,
                                         double radius, int points);

/// Returns a unit vector perpendicular to the unit vector `axis`: the direction of `hint` without its component
/// along `axis`. If `hint` is nearly parallel to `axis`, uses a coordinate axis instead of `hint`.
Eigen::Vector3d across(const Eigen::Vector3d& axis, const Eigen::Vector3d& hint);

/// Inputs of an actor's constructor, for one view of a scene. `motion`, `body` and `construction` outlive the
/// actors.
struct Setting {
  const scene::Scene& scene;
  const PictureMotion& motion;
  const BodyFigure& body;
  const Scales& scales;
  const Construction* construction;  ///< null if no part of the construction is shown
  Eigen::Vector3d axisLengths;       ///< drawn lengths of the principal axes
};

/// Object drawn in a view. The drawing is a pure function of the scene, the time and the state.
class Actor {
 public:
  virtual ~Actor() = default;

  virtual void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const = 0;
  /// Returns the points that must be inside the picture at this instant, in V.
  virtual std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const = 0;
  /// Returns the radius of a ball about the origin that must be inside the picture too; 0: no ball.
  virtual double ballRadius() const { return 0; }
  /// Returns the point from which the object's solids grow when they appear (presence.h), in V.
  virtual Eigen::Vector3d growsFrom(const PictureState& /*state*/) const { return Eigen::Vector3d::Zero(); }
};

}  // namespace poinsot::stage
