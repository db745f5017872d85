// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_solids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "figure/visibility.h"
#include "figure/visibility_tree.h"

namespace poinsot::figure {
namespace {

// Tube as a chain of cylinders with balls at the joints. The ends of the tube are flat, as in the renderer.
class TubeOccluder : public Occluder {
 public:
  TubeOccluder(std::vector<glm::dvec3> points_C, bool closed, double radius, double lift, double near)
      : points_(std::move(points_C)),
        closed_(closed),
        radius_(radius),
        lift_(lift),
        near_(near),
        tree_(boundsOfPieces()) {}

  bool hides(const SightLine& sight, double t) const override {
    const Line line{sight.origin_C, sight.direction_C};
    const double limit = t + lift_;  // the tube is drawn nearer to the eye by lift_
    return tree_.any(line, limit, [&](std::size_t k) {
      return !behind(k) && (meetsCylinder(k, sight, limit) || meetsJoint(k, sight, limit));
    });
  }

 private:
  std::size_t pieces() const { return closed_ ? points_.size() : points_.size() - 1; }
  glm::dvec3 point(std::size_t i) const { return points_[i % points_.size()]; }
  bool behind(std::size_t k) const { return -std::max(point(k).z, point(k + 1).z) <= near_; }

  std::vector<Bounds> boundsOfPieces() const {
    std::vector<Bounds> all;
    for (std::size_t k = 0; k < pieces(); ++k) {
      Bounds bounds;
      for (const glm::dvec3& p : {point(k), point(k + 1)}) {
        bounds.include(p - radius_);
        bounds.include(p + radius_);
      }
      all.push_back(bounds);
    }
    return all;
  }

  bool meetsCylinder(std::size_t k, const SightLine& sight, double t) const {
    const glm::dvec3 from = point(k) - sight.origin_C, along = point(k + 1) - point(k), d = sight.direction_C;
    const double length2 = glm::dot(along, along);
    if (length2 == 0) return false;
    const auto across = [&](glm::dvec3 v) { return v - glm::dot(v, along) / length2 * along; };
    const glm::dvec3 m = across(-from), n = across(d);
    const double a = glm::dot(n, n), b = glm::dot(m, n), c = glm::dot(m, m) - radius_ * radius_;
    const double discriminant = b * b - a * c;
    if (a == 0 || discriminant < 0) return false;
    const double enter = (-b - std::sqrt(discriminant)) / a;
    const double height = glm::dot(enter * d - from, along) / length2;
    return enter > 0 && enter < t && height >= 0 && height <= 1;
  }

  // Tests the ball at the far end of piece k. There is a ball only if another piece follows.
  bool meetsJoint(std::size_t k, const SightLine& sight, double t) const {
    if (!closed_ && k + 1 == pieces()) return false;
    const SphereMap::Chord chord = SphereMap(point(k + 1), glm::dmat3(radius_)).chord(sight);
    return chord.meets && chord.enter < t;
  }

  std::vector<glm::dvec3> points_;
  bool closed_;
  double radius_, lift_, near_;
  BoundsTree tree_;
};

}  // namespace

std::unique_ptr<const Occluder> makeTubeOccluder(const draw::Camera& camera, const draw::Curve& curve) {
  if (curve.radius_V <= 0 || curve.points_V.size() < 2) return nullptr;
  std::vector<glm::dvec3> points_C;
  for (const glm::vec3& p : curve.points_V) points_C.push_back(toCameraExactly(camera, p));
  return std::make_unique<TubeOccluder>(std::move(points_C), curve.closed, curve.radius_V, curve.lift_V,
                                        camera.near);
}

}  // namespace poinsot::figure
