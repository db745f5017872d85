// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/poinsot_construction.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"

namespace poinsot::stage {

/// Poinsot's construction in the picture. The energy ellipsoid (eq 38) rolls on the invariable plane (eq 40) and
/// touches it at the tip of omega. If something acts on the body, the ellipsoid and the plane change from instant
/// to instant.
class Construction {
 public:
  /// @pre the body is not at rest all the time.
  Construction(const PictureMotion& motion, const Scales& scales);

  /// Returns the scale of the construction, in picture lengths per rad/s.
  double scale() const { return scale_; }
  /// Returns the ellipsoid's semi-axes at the instant when they are longest, in the order of the principal axes.
  const Eigen::Vector3d& semiAxes() const { return semiAxes_; }
  /// Returns the vectors of the ellipsoid's semi-axes at an instant, in the order of the principal axes. @pre not
  /// at rest.
  Eigen::Matrix3d semiAxes_V(const PictureState& state) const;
  /// Returns the distance of the plane from the centre. @pre not at rest.
  double planeHeight(const PictureState& state) const;
  /// Returns the two vectors from the centre of the plane's square to the middles of its edges, along its grid.
  /// @pre not at rest.
  Eigen::Matrix<double, 3, 2> planeHalfEdges_V(const PictureState& state) const;
  /// Returns the corners of the plane's square, in order. @pre not at rest.
  std::array<Eigen::Vector3d, 4> planeCorners_V(const PictureState& state) const;
  /// Returns the spacing of the plane's grid, rad/s: 1, 2 or 5 times a power of ten.
  double gridSpacing() const { return spacing_; }

 private:
  physics::PrincipalMoments moments_;
  double scale_;
  Eigen::Vector3d semiAxes_;
  Eigen::Vector3d gridHint_W_;  // approximate direction of one family of grid lines
  double spacing_, halfWidth_;
};

}  // namespace poinsot::stage
