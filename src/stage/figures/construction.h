// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/poinsot_construction.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"

namespace poinsot::stage {

/// Poinsot's construction as it lies in the picture: the energy ellipsoid (eq 38) rolling on the invariable plane
/// (eq 40), in contact at the tip of omega. Where something acts on the body, both are those of the instant.
class Construction {
 public:
  /// @pre the body is not at rest all the time.
  Construction(const PictureMotion& motion, const Scales& scales);

  /// Picture lengths per rad/s.
  double scale() const { return scale_; }
  /// Semi-axes of the ellipsoid in the order of the principal axes, where they are longest.
  const Eigen::Vector3d& semiAxes() const { return semiAxes_; }
  /// The ellipsoid's semi-axis vectors at an instant, in the order of the principal axes. @pre not at rest.
  Eigen::Matrix3d semiAxes_V(const PictureState& state) const;
  /// Distance of the plane from the centre. @pre not at rest.
  double planeHeight(const PictureState& state) const;
  /// Half-edges of the plane's square, along its grid. @pre not at rest.
  Eigen::Matrix<double, 3, 2> planeHalfEdges_V(const PictureState& state) const;
  /// Corners of the plane's square, in order. @pre not at rest.
  std::array<Eigen::Vector3d, 4> planeCorners_V(const PictureState& state) const;
  /// Spacing of the plane's grid in rad/s: 1, 2 or 5 times a power of ten.
  double gridSpacing() const { return spacing_; }

 private:
  physics::PrincipalMoments moments_;
  double scale_;
  Eigen::Vector3d semiAxes_;
  Eigen::Vector3d gridHint_W_;  // about where one family of the grid's lines runs
  double spacing_, halfWidth_;
};

}  // namespace poinsot::stage
