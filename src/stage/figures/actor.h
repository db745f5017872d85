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

/// How many sheets' worth of glass is at each place of a hollow thing.
struct GlassShares {
  double near = 1, far = 1, rim = 1;
};

/// Between a place and its label, in the label's own size.
inline constexpr double kLabelGap = 0.35;

/// What actors draw on, for one picture: V's axes, lengths in the picture's unit. The list's camera is set.
struct Canvas {
  draw::DrawList& list;
  std::vector<Label>& labels;
  const Palette& colors;
  const scene::LabelTexts& names;
  double line_px = 2;    ///< width of an ordinary line
  double thickness = 1;  ///< factor on arrows
  double type_px = 32;   ///< size of an ordinary label; 0: labels are not wanted
  double least_px = 0;   ///< no label is smaller
  bool still = false;    ///< labels are there or not, none is faint

  /// A flat line; `width` in ordinary lines, `lift` towards the eye.
  void line(const std::vector<Eigen::Vector3d>& points_V, bool closed, const draw::Color& color, double width = 1,
            double lift = 0.004) const;
  /// A straight line in dashes, a whole number of them, that begins and ends with one.
  void dashes(const Eigen::Vector3d& from_V, const Eigen::Vector3d& to_V, const draw::Color& color,
              double width = 1) const;
  /// From the origin; `radius` of its shaft.
  void arrow(const Eigen::Vector3d& tip_V, double radius, const draw::Color& color) const;
  void dot(const Eigen::Vector3d& at_V, double radius, const draw::Color& color) const;
  /// A round tube.
  void tube(const std::vector<Eigen::Vector3d>& points_V, bool closed, double radius,
            const draw::Color& color) const;
  /// A hollow ellipsoid about the origin, its sheets and rim so many times as thick as a sheet of that opacity.
  draw::GlassEllipsoid& glassEllipsoid(const Eigen::Matrix3d& semiAxes_V, const draw::Color& color, double opacity,
                                       const GlassShares& shares) const;
  /// How opaque glass is: `share` times as thick as a sheet of that opacity, and thinner on dark paper. 1 is
  /// opaque everywhere.
  float glass(double opacity, double share = 1) const;
  /// An arrow that does not begin at the origin.
  void arrowFrom(const Eigen::Vector3d& from_V, const Eigen::Vector3d& tip_V, double radius,
                 const draw::Color& color) const;
  /// Beside a point, on the side that leads away from the picture of `inside_V`.
  void label(const std::string& tex, const Eigen::Vector3d& at_V, const Eigen::Vector3d& inside_V,
             const draw::Color& color, double size = 1) const;
  /// Beside a place of the picture, in a direction; `size` in ordinary labels, `gap` in the label's own size. One
  /// that is faint for a while is in a still whole, or not there where it would hardly be seen.
  void labelAt(const std::string& tex, glm::vec2 at_px, glm::vec2 direction, const draw::Color& color,
               double size = 1, double gap = kLabelGap, float opacity = 1) const;
  /// The same of a thing whose name the scene may choose.
  void label(scene::LabelName name, const Eigen::Vector3d& at_V, const Eigen::Vector3d& inside_V,
             const draw::Color& color, double size = 1) const {
    label(names[name], at_V, inside_V, color, size);
  }
  void labelAt(scene::LabelName name, glm::vec2 at_px, glm::vec2 direction, const draw::Color& color,
               double size = 1, double gap = kLabelGap, float opacity = 1) const {
    labelAt(names[name], at_px, direction, color, size, gap, opacity);
  }
  /// Where the camera sees a point.
  glm::vec2 at_px(const Eigen::Vector3d& at_V) const;
};

/// A share of one colour over another, in linear light: 0 is the second.
draw::Color mixed(const draw::Color& color, const draw::Color& over, double share);

/// A circle about the origin's axis: radius `radius` around `centre_V`, across `axis_V` (a unit vector).
std::vector<Eigen::Vector3d> circleAbout(const Eigen::Vector3d& centre_V, const Eigen::Vector3d& axis_V,
                                         double radius, int points);

/// A unit vector across a unit vector: `hint` without its part along it, or another axis where that is short.
Eigen::Vector3d across(const Eigen::Vector3d& axis, const Eigen::Vector3d& hint);

/// What an actor is made for: one view of a scene.
struct Setting {
  const scene::Scene& scene;
  const PictureMotion& motion;  ///< outlives the actors
  const BodyFigure& body;       ///< outlives the actors
  const Scales& scales;
  const Construction* construction;  ///< outlives the actors; null where none of it is shown
  Eigen::Vector3d axisLengths;       ///< of the principal axes as they are drawn
};

/// One drawn thing of a view. Its picture is a pure function of the scene, the time and the state.
class Actor {
 public:
  virtual ~Actor() = default;

  virtual void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const = 0;
  /// What the frame must hold at that instant, in V.
  virtual std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const = 0;
  /// Of a ball about the origin that the frame must hold besides; 0: none.
  virtual double ballRadius() const { return 0; }
  /// The point that its solids grow out of when they come (presence.h), in V.
  virtual Eigen::Vector3d growsFrom(const PictureState& /*state*/) const { return Eigen::Vector3d::Zero(); }
};

}  // namespace poinsot::stage
