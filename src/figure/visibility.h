// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// What lies between the eye and a point.
struct Sight {
  bool hidden = false;       ///< an opaque solid is in front; the rest means nothing then
  std::uint64_t sheets = 0;  ///< changes wherever a sheet begins or ends to be in front
  double transmittance = 1;  ///< share of the point's light that the sheets in front let through
  glm::dvec3 veil{0};        ///< linear light that those sheets add; the eye sees veil + transmittance * light
};

/// Which points of a draw list the eye sees, and through what: from the values alone, in double precision, no
/// pixels. Flat curves hide nothing; lines on sheets (graticule, grid) and a sheet's border are left out of the
/// veil. As in the rendered picture, a solid or sheet that is not wholly in front of the camera is not there.
class Visibility {
 public:
  explicit Visibility(const draw::DrawList& list);
  ~Visibility();
  Visibility(Visibility&&) noexcept;

  /// @param lift_V how much nearer to the eye, along the view, the point is taken to be (Curve::lift_V).
  Sight of(glm::dvec3 point_V, double lift_V = 0) const;

 private:
  struct Scene;
  std::unique_ptr<const Scene> scene_;  // the shapes as the eye has them: of no use to a caller
};

/// A point's coordinates in camera axes C, in double precision.
glm::dvec3 toCameraExactly(const draw::Camera& camera, glm::dvec3 point_V);

/// Where a point given in camera axes appears, in pixels as project(). @pre in front of the camera.
glm::dvec2 projectExactly(const draw::Camera& camera, glm::dvec3 point_C);

}  // namespace poinsot::figure
