// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// Solids and sheets between the eye and a point.
struct Sight {
  bool hidden = false;       ///< an opaque solid is in front; the other fields have no meaning then
  std::uint64_t sheets = 0;  ///< a bit for each side of a sheet in front; changes where a sheet begins or ends
  double transmittance = 1;  ///< share of the point's light that the sheets in front let through
  glm::dvec3 veil{0};  ///< linear light that the sheets in front add; the eye sees veil + transmittance * light
};

/// Visibility of points through the solids and sheets of a draw list, computed from values in double precision,
/// without pixels. Flat curves hide nothing. The veil has no lines on sheets (graticule, grid) and no borders of
/// sheets. As in the rendered picture, a solid or sheet that is not wholly in front of the camera is left out.
class Visibility {
 public:
  explicit Visibility(const draw::DrawList& list);
  ~Visibility();
  Visibility(Visibility&&) noexcept;

  /// @param lift_V  distance along the view by which the point counts as nearer to the eye (Curve::lift_V).
  Sight of(glm::dvec3 point_V, double lift_V = 0) const;

 private:
  struct Scene;
  std::unique_ptr<const Scene> scene_;
};

glm::dvec3 toCameraExactly(const draw::Camera& camera, glm::dvec3 point_V);

/// Returns the pixel position of a point in camera axes, as project() does. @pre in front of the camera.
glm::dvec2 projectExactly(const draw::Camera& camera, glm::dvec3 point_C);

}  // namespace poinsot::figure
