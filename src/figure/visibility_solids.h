// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// A line of sight: the points origin_C + t * direction_C of camera axes C, where origin_C.z = 0 (the eye, or
/// beside it with parallel rays) and direction_C.z = -1, so that t is the distance along the view, as depth is.
struct SightLine {
  glm::dvec3 origin_C{0};
  glm::dvec3 direction_C{0, 0, -1};

  glm::dvec3 at(double t) const { return origin_C + t * direction_C; }
};

/// Something opaque, as the eye has it.
class Occluder {
 public:
  virtual ~Occluder() = default;
  /// Whether the line of sight meets it nearer than `t`.
  virtual bool hides(const SightLine& sight, double t) const = 0;
};

/// Every opaque solid of a list that is wholly in front of the camera, and its tubes.
std::vector<std::unique_ptr<const Occluder>> occludersOf(const draw::DrawList& list);

/// The affine image of the unit sphere: where a line of sight enters and leaves it.
struct SphereMap {
  glm::dvec3 centre_C{0};
  glm::dmat3 toUnitSphere{1};  ///< inverse of the semi-axis matrix

  SphereMap(glm::dvec3 centre, const glm::dmat3& semiAxes_C);

  struct Chord {
    double enter = 0;
    double leave = 0;
    bool meets = false;
  };
  Chord chord(const SightLine& sight) const;
  /// Unit normal, outwards, at distance t of the line. @pre t is an end of its chord.
  glm::dvec3 normal_C(const SightLine& sight, double t) const;
};

/// Whether an ellipsoid lies wholly beyond the camera's near distance.
bool inFront(const draw::Camera& camera, glm::dvec3 centre_C, const glm::dmat3& semiAxes_C);

/// Directions or matrices of columns from V to C.
glm::dvec3 turnToCamera(const draw::Camera& camera, glm::vec3 direction_V);
glm::dmat3 turnToCamera(const draw::Camera& camera, const glm::mat3& columns_V);

/// Null where the mesh is empty or not wholly in front of the camera.
std::unique_ptr<const Occluder> makeMeshOccluder(const draw::Camera& camera, const draw::Mesh& mesh);

/// Null for a flat curve (radius_V = 0) and for one with fewer than two points.
std::unique_ptr<const Occluder> makeTubeOccluder(const draw::Camera& camera, const draw::Curve& curve);

}  // namespace poinsot::figure
