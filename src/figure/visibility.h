// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// Effect of the solids and sheets between the eye and a point.
struct Sight {
  /// Whether an opaque solid is in front of the point. If so, the other fields have no meaning.
  bool hidden = false;
  /// One bit for each side of a sheet in front of the point. The bits change where a sheet begins or ends.
  std::uint64_t sheets = 0;
  double transmittance = 1;  ///< fraction of the point's light that passes through the sheets in front
  /// Linear light that the sheets in front add. The eye sees veil + transmittance * light.
  glm::dvec3 veil{0};
};

/// Visibility of points behind the solids and sheets of a draw list. It is computed in double precision, without
/// rendering. Flat curves hide nothing. Lines on sheets (graticule, grid) and borders of sheets are ignored. As in
/// the rendered picture, a solid or sheet that is not completely in front of the camera is left out.
class Visibility {
 public:
  explicit Visibility(const draw::DrawList& list);
  ~Visibility();
  Visibility(Visibility&&) noexcept;

  /// @param lift_V  distance by which the point is treated as nearer to the eye (Curve::lift_V).
  Sight of(glm::dvec3 point_V, double lift_V = 0) const;

 private:
  struct Scene;
  std::unique_ptr<const Scene> scene_;
};

glm::dvec3 toCameraExactly(const draw::Camera& camera, glm::dvec3 point_V);

/// Returns the position in pixels of a point in camera axes, as project() does. @pre in front of the camera.
glm::dvec2 projectExactly(const draw::Camera& camera, glm::dvec3 point_C);

}  // namespace poinsot::figure
