// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// Line of sight: points origin_C + t * direction_C in camera axes C. It starts at the eye or, with parallel rays,
/// in the plane of the eye, so origin_C.z is 0. direction_C.z is -1, so t is the distance along the view.
struct SightLine {
  glm::dvec3 origin_C{0};
  glm::dvec3 direction_C{0, 0, -1};

  glm::dvec3 at(double t) const { return origin_C + t * direction_C; }
};

class Occluder {
 public:
  virtual ~Occluder() = default;
  /// Returns whether the line of sight meets the solid at a distance less than `t`.
  virtual bool hides(const SightLine& sight, double t) const = 0;
};

/// Returns all tubes of a list, and its other solids that are completely in front of the camera.
std::vector<std::unique_ptr<const Occluder>> occludersOf(const draw::DrawList& list);

/// Ellipsoid as an affine image of the unit sphere. It computes where a line of sight meets the ellipsoid.
struct SphereMap {
  glm::dvec3 centre_C{0};
  glm::dmat3 toUnitSphere{1};  ///< inverse of the matrix whose columns are the semi-axes

  SphereMap(glm::dvec3 centre, const glm::dmat3& semiAxes_C);

  struct Chord {
    double enter = 0;
    double leave = 0;
    bool meets = false;
  };
  Chord chord(const SightLine& sight) const;
  /// Returns the outward unit normal of the ellipsoid at a point of the line. @pre t is an end of its chord.
  glm::dvec3 normal_C(const SightLine& sight, double t) const;
};

/// Returns whether an ellipsoid is completely farther away than the camera's near distance.
bool inFront(const draw::Camera& camera, glm::dvec3 centre_C, const glm::dmat3& semiAxes_C);

/// Rotates a direction, or the columns of a matrix, from picture axes V to camera axes C.
glm::dvec3 turnToCamera(const draw::Camera& camera, glm::vec3 direction_V);
glm::dmat3 turnToCamera(const draw::Camera& camera, const glm::mat3& columns_V);

/// Returns the occluder of a mesh, or null if mesh.mesh is null or not completely in front of the camera.
std::unique_ptr<const Occluder> makeMeshOccluder(const draw::Camera& camera, const draw::Mesh& mesh);

/// Returns the occluder of a tube, or null for a flat curve (radius_V = 0) or fewer than two points.
std::unique_ptr<const Occluder> makeTubeOccluder(const draw::Camera& camera, const draw::Curve& curve);

}  // namespace poinsot::figure
