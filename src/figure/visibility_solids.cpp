// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_solids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "figure/visibility.h"

namespace poinsot::figure {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class EllipsoidOccluder : public Occluder {
 public:
  explicit EllipsoidOccluder(const SphereMap& sphere) : sphere_(sphere) {}

  bool hides(const SightLine& sight, double t) const override {
    const SphereMap::Chord chord = sphere_.chord(sight);
    return chord.meets && chord.enter < t;
  }

 private:
  SphereMap sphere_;
};

class BoxOccluder : public Occluder {
 public:
  BoxOccluder(glm::dvec3 centre_C, const glm::dmat3& halfAxes_C)
      : toCube_(glm::inverse(halfAxes_C)), centre_C_(centre_C) {}

  bool hides(const SightLine& sight, double t) const override {
    const glm::dvec3 d = toCube_ * sight.direction_C, centre = toCube_ * (centre_C_ - sight.origin_C);
    double enter = -kInfinity, leave = kInfinity;
    for (int i = 0; i < 3; ++i) {
      // Infinite if the line is parallel to the faces
      const double a = (centre[i] - 1) / d[i], b = (centre[i] + 1) / d[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave && enter < t;
  }

 private:
  glm::dmat3 toCube_;
  glm::dvec3 centre_C_;
};

/// Truncated cone from the disc at `from` along `axis`. Its radius at the height h is r0 + slope h.
class FrustumOccluder : public Occluder {
 public:
  FrustumOccluder(glm::dvec3 from_C, glm::dvec3 to_C, double fromRadius, double toRadius)
      : from_(from_C),
        height_(glm::distance(from_C, to_C)),
        axis_((to_C - from_C) / height_),
        radius_(fromRadius),
        slope_((toRadius - fromRadius) / height_) {}

  bool hides(const SightLine& sight, double t) const override {
    return meetsDisc(sight, 0, t) || meetsDisc(sight, height_, t) || meetsSide(sight, t);
  }

 private:
  bool meetsDisc(const SightLine& sight, double height, double t) const {
    const glm::dvec3 centre = from_ + height * axis_ - sight.origin_C;
    const double hit = glm::dot(centre, axis_) / glm::dot(sight.direction_C, axis_);
    if (!(hit > 0 && hit < t)) return false;
    const glm::dvec3 offset = hit * sight.direction_C - centre;
    const double radius = radius_ + slope_ * height;
    return glm::dot(offset, offset) <= radius * radius;
  }

  // Solves |x - h axis|^2 = (r0 + slope h)^2 for points x = s + u d of the line of sight. s is the point of the
  // line nearest to the centre of the first disc, so that no large numbers cancel.
  bool meetsSide(const SightLine& sight, double t) const {
    const glm::dvec3& d = sight.direction_C;
    const glm::dvec3 from = from_ - sight.origin_C;
    const double t0 = glm::dot(from, d) / glm::dot(d, d);
    const glm::dvec3 o = t0 * d - from;
    const double du = glm::dot(d, axis_), ou = glm::dot(o, axis_), kk = 1 + slope_ * slope_;
    const double a = glm::dot(d, d) - kk * du * du;
    const double b = glm::dot(d, o) - kk * du * ou - slope_ * radius_ * du;
    const double c = glm::dot(o, o) - kk * ou * ou - 2 * slope_ * radius_ * ou - radius_ * radius_;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return false;
    const double q = b > 0 ? -b - std::sqrt(discriminant) : -b + std::sqrt(discriminant);
    const auto counts = [&](double u) {
      const double h = ou + u * du;
      return t0 + u > 0 && t0 + u < t && h >= 0 && h <= height_ && radius_ + slope_ * h >= 0;
    };
    return counts(q / a) || (q != 0 && counts(c / q));
  }

  glm::dvec3 from_;
  double height_;
  glm::dvec3 axis_;
  double radius_, slope_;
};

using Occluders = std::vector<std::unique_ptr<const Occluder>>;

void add(Occluders& all, const draw::Camera& camera, const draw::Ellipsoid& e) {
  const glm::dvec3 centre_C = toCameraExactly(camera, e.centre_V);
  const glm::dmat3 semiAxes_C = turnToCamera(camera, e.semiAxes_V);
  if (inFront(camera, centre_C, semiAxes_C))
    all.push_back(std::make_unique<EllipsoidOccluder>(SphereMap(centre_C, semiAxes_C)));
}

void add(Occluders& all, const draw::Camera& camera, const draw::Frustum& f) {
  const glm::dvec3 from_C = toCameraExactly(camera, f.from_V), to_C = toCameraExactly(camera, f.to_V);
  const double reach = static_cast<double>(std::max(f.fromRadius, f.toRadius));
  if (from_C == to_C || -std::max(from_C.z, to_C.z) - reach <= static_cast<double>(camera.near)) return;
  all.push_back(std::make_unique<FrustumOccluder>(from_C, to_C, f.fromRadius, f.toRadius));
}

void add(Occluders& all, const draw::Camera& camera, const draw::Box& b) {
  const glm::dvec3 centre_C = toCameraExactly(camera, b.centre_V);
  const glm::dmat3 h = turnToCamera(camera, b.halfAxes_V);
  const double reach = std::abs(h[0].z) + std::abs(h[1].z) + std::abs(h[2].z);
  if (-centre_C.z - reach > static_cast<double>(camera.near))
    all.push_back(std::make_unique<BoxOccluder>(centre_C, h));
}

void add(Occluders& all, const draw::Camera& camera, const draw::Mesh& mesh) {
  if (auto occluder = makeMeshOccluder(camera, mesh)) all.push_back(std::move(occluder));
}

void add(Occluders& all, const draw::Camera& camera, const draw::Curve& curve) {
  if (auto occluder = makeTubeOccluder(camera, curve)) all.push_back(std::move(occluder));
}

}  // namespace

std::vector<std::unique_ptr<const Occluder>> occludersOf(const draw::DrawList& list) {
  Occluders all;
  const auto addAll = [&](const auto& solids) {
    for (const auto& solid : solids) add(all, list.camera, solid);
  };
  addAll(list.ellipsoids);
  addAll(list.frustums);
  addAll(list.boxes);
  addAll(list.meshes);
  addAll(list.curves);
  return all;
}

SphereMap::SphereMap(glm::dvec3 centre, const glm::dmat3& semiAxes_C)
    : centre_C(centre), toUnitSphere(glm::inverse(semiAxes_C)) {}

// Starts from the point of the line nearest to the centre, so that no large numbers cancel.
SphereMap::Chord SphereMap::chord(const SightLine& sight) const {
  const glm::dvec3& direction = sight.direction_C;
  const glm::dvec3 centre = centre_C - sight.origin_C;
  const double t0 = glm::dot(centre, direction) / glm::dot(direction, direction);
  const glm::dvec3 o = toUnitSphere * (t0 * direction - centre), d = toUnitSphere * direction;
  const double a = glm::dot(d, d), along = glm::dot(o, d) / a;
  const glm::dvec3 offset = o - along * d;
  const double room = 1 - glm::dot(offset, offset);
  if (room < 0) return {};
  const double half = std::sqrt(room / a);
  return {t0 - along - half, t0 - along + half, true};
}

glm::dvec3 SphereMap::normal_C(const SightLine& sight, double t) const {
  return glm::normalize((toUnitSphere * (sight.at(t) - centre_C)) * toUnitSphere);
}

bool inFront(const draw::Camera& camera, glm::dvec3 centre_C, const glm::dmat3& semiAxes_C) {
  const glm::dvec3 zRow(semiAxes_C[0].z, semiAxes_C[1].z, semiAxes_C[2].z);
  return -centre_C.z - glm::length(zRow) > static_cast<double>(camera.near);
}

glm::dvec3 turnToCamera(const draw::Camera& camera, glm::vec3 direction_V) {
  return glm::dvec3(direction_V) * glm::dmat3(camera.R_VC);
}

glm::dmat3 turnToCamera(const draw::Camera& camera, const glm::mat3& columns_V) {
  return glm::transpose(glm::dmat3(camera.R_VC)) * glm::dmat3(columns_V);
}

}  // namespace poinsot::figure
