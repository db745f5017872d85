// SPDX-License-Identifier: Apache-2.0
// Sheets in front of points. Opacities are computed as in composite.frag, but lines on sheets are ignored.
#include "figure/visibility_sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "figure/visibility.h"

namespace poinsot::figure {
namespace {

std::uint64_t bit(std::size_t index) { return index < 64 ? std::uint64_t{1} << index : 0; }

// Returns the opacity of a sheet: `flatOn` where the sheet faces the eye, rising to `rim` where it is seen
// edge-on.
// @param normal_C  unit normal to either side
double opacityOf(glm::dvec3 normal_C, const SightLine& sight, float flatOn, float rim) {
  const double facing = std::abs(glm::dot(normal_C, glm::normalize(sight.direction_C)));
  const double grazing = (1 - facing) * (1 - facing) * (1 - facing);
  return glm::mix(static_cast<double>(flatOn), static_cast<double>(rim), grazing);
}

class GlassSheet : public Sheet {
 public:
  GlassSheet(const draw::GlassEllipsoid& glass, const SphereMap& sphere, std::size_t firstMark)
      : glass_(glass), sphere_(sphere), firstMark_(firstMark) {}

  void meet(const SightLine& sight, double t, std::vector<SheetHit>& hits) const override {
    const SphereMap::Chord chord = sphere_.chord(sight);
    if (!chord.meets) return;
    add(sight, chord.enter, glass_.nearOpacity, firstMark_, t, hits);
    add(sight, chord.leave, glass_.farOpacity, firstMark_ + 1, t, hits);
  }

 private:
  void add(const SightLine& sight, double at, float flatOn, std::size_t mark, double t,
           std::vector<SheetHit>& hits) const {
    if (at >= t) return;
    const double opacity = opacityOf(sphere_.normal_C(sight, at), sight, flatOn, glass_.rimOpacity);
    hits.push_back({at, opacity, glass_.color, bit(mark)});
  }

  draw::GlassEllipsoid glass_;
  SphereMap sphere_;
  std::size_t firstMark_;
};

class PlaneSheet : public Sheet {
 public:
  PlaneSheet(const draw::Camera& camera, const draw::GridPlane& plane, std::size_t mark)
      : plane_(plane),
        centre_C_(toCameraExactly(camera, plane.centre_V)),
        u_C_(turnToCamera(camera, plane.u_V)),
        v_C_(turnToCamera(camera, plane.v_V)),
        shadowCentre_C_(toCameraExactly(camera, plane.shadowCentre_V)),
        mark_(mark) {}

  bool inFront(double near) const {
    const double reach = std::abs(u_C_.z) + std::abs(v_C_.z);
    return -centre_C_.z - reach > near;
  }

  void meet(const SightLine& sight, double t, std::vector<SheetHit>& hits) const override {
    const glm::dvec3 normal = glm::cross(u_C_, v_C_);
    const double at = glm::dot(normal, centre_C_ - sight.origin_C) / glm::dot(normal, sight.direction_C);
    if (!(at > 0 && at < t)) return;
    const glm::dvec3 x = sight.at(at) - centre_C_;
    const auto share = [&](const glm::dvec3& edge) { return glm::dot(x, edge) / glm::dot(edge, edge); };
    if (std::abs(share(u_C_)) > 1 || std::abs(share(v_C_)) > 1) return;
    const glm::dvec3 fromShadow = sight.at(at) - shadowCentre_C_;
    hits.push_back(shaded(at, glm::cross(fromShadow, glm::normalize(normal))));
  }

 private:
  // Returns the point of the plane that the line of sight meets, with the shadow over the plane's own colour.
  // @param fromShadow  vector whose length is the distance from the shadow's centre
  SheetHit shaded(double t, const glm::dvec3& fromShadow) const {
    const double r = static_cast<double>(plane_.shadowRadius_V), tint = static_cast<double>(plane_.opacity);
    const double q = r > 0 ? glm::dot(fromShadow, fromShadow) / (r * r) : 1e9;
    const double dark = static_cast<double>(plane_.shadowOpacity) *
                        std::max(std::exp2(-2 * q) - static_cast<double>(draw::GridPlane::kShadowEnd), 0.0);
    const double opacity = dark + tint * (1 - dark);
    const float share = opacity > 0 ? static_cast<float>(dark / opacity) : 0;
    return {t, opacity, share * draw::Color(0.02f) + (1 - share) * plane_.color, bit(mark_)};
  }

  draw::GridPlane plane_;
  glm::dvec3 centre_C_, u_C_, v_C_, shadowCentre_C_;
  std::size_t mark_;
};

/// Cone sheet. Its radius at the height h above the apex is slope * h.
class ConeSheet : public Sheet {
 public:
  ConeSheet(const draw::Camera& camera, const draw::GlassCone& cone, std::size_t firstMark)
      : cone_(cone),
        apex_C_(toCameraExactly(camera, cone.apex_V)),
        axis_C_(glm::normalize(turnToCamera(camera, cone.axis_V))),
        slope_(std::tan(static_cast<double>(cone.halfAngle_rad))),
        height_(static_cast<double>(cone.height_V)),
        firstMark_(firstMark) {}

  bool inFront(double near) const {
    const double across = std::sqrt(std::max(1 - axis_C_.z * axis_C_.z, 0.0));
    const glm::dvec3 base_C = apex_C_ + height_ * axis_C_;
    return std::min(-apex_C_.z, -base_C.z - slope_ * height_ * across) > near;
  }

  void meet(const SightLine& sight, double t, std::vector<SheetHit>& hits) const override {
    const glm::dvec3 d = sight.direction_C, apex = apex_C_ - sight.origin_C;
    const double t0 = glm::dot(apex, d) / glm::dot(d, d), kk = 1 + slope_ * slope_;
    // Computed from the point of the line nearest to the apex, so that no large numbers cancel.
    const glm::dvec3 o = t0 * d - apex;
    const double du = glm::dot(d, axis_C_), ou = glm::dot(o, axis_C_);
    const double a = glm::dot(d, d) - kk * du * du, b = glm::dot(d, o) - kk * du * ou,
                 c = glm::dot(o, o) - kk * ou * ou;
    if (b * b - a * c < 0) return;
    const double root = std::sqrt(b * b - a * c), q = b > 0 ? -b - root : -b + root;
    add(sight, t0 + q / a, t, hits);
    if (q != 0) add(sight, t0 + c / q, t, hits);
  }

 private:
  void add(const SightLine& sight, double at, double t, std::vector<SheetHit>& hits) const {
    if (!(at > 0 && at < t)) return;
    const glm::dvec3 x = sight.at(at) - apex_C_;
    const double height = glm::dot(x, axis_C_);
    if (height <= 0 || height > height_) return;
    const glm::dvec3 outwards = glm::normalize((x - height * axis_C_) - slope_ * slope_ * height * axis_C_);
    const bool outside = glm::dot(outwards, sight.direction_C) < 0;
    const double opacity =
        opacityOf(outwards, sight, outside ? cone_.nearOpacity : cone_.farOpacity, cone_.rimOpacity);
    hits.push_back({at, opacity, cone_.color, bit(outside ? firstMark_ : firstMark_ + 1)});
  }

  draw::GlassCone cone_;
  glm::dvec3 apex_C_, axis_C_;
  double slope_, height_;
  std::size_t firstMark_;
};

class PolygonSheet : public Sheet {
 public:
  PolygonSheet(const draw::Camera& camera, const draw::GlassPolygon& polygon, std::size_t mark)
      : polygon_(polygon), mark_(mark) {
    for (const glm::vec3& corner_V : polygon.corners_V) corners_C_.push_back(toCameraExactly(camera, corner_V));
    for (std::size_t i = 0; i + 2 < corners_C_.size(); ++i)
      normal_C_ += glm::cross(corners_C_[i + 1] - corners_C_[0], corners_C_[i + 2] - corners_C_[0]);
  }

  bool inFront(double near) const {
    return std::ranges::all_of(corners_C_, [&](const glm::dvec3& corner) { return -corner.z > near; });
  }

  void meet(const SightLine& sight, double t, std::vector<SheetHit>& hits) const override {
    if (corners_C_.size() < 3) return;
    const double at = glm::dot(normal_C_, corners_C_[0] - sight.origin_C) / glm::dot(normal_C_, sight.direction_C);
    if (!(at > 0 && at < t)) return;
    for (std::size_t i = 0; i < corners_C_.size(); ++i) {
      const glm::dvec3 edge = corners_C_[(i + 1) % corners_C_.size()] - corners_C_[i];
      if (glm::dot(glm::cross(edge, sight.at(at) - corners_C_[i]), normal_C_) < 0) return;
    }
    hits.push_back({at, static_cast<double>(polygon_.opacity), polygon_.color, bit(mark_)});
  }

 private:
  draw::GlassPolygon polygon_;
  std::vector<glm::dvec3> corners_C_;
  glm::dvec3 normal_C_{0};
  std::size_t mark_;
};

}  // namespace

std::vector<std::unique_ptr<const Sheet>> sheetsOf(const draw::DrawList& list) {
  const double near = static_cast<double>(list.camera.near);
  std::vector<std::unique_ptr<const Sheet>> sheets;
  std::size_t mark = 0;
  for (const draw::GlassEllipsoid& glass : list.glassEllipsoids) {
    const glm::dvec3 centre_C = toCameraExactly(list.camera, glass.centre_V);
    const glm::dmat3 semiAxes_C = turnToCamera(list.camera, glass.semiAxes_V);
    if (inFront(list.camera, centre_C, semiAxes_C))
      sheets.push_back(std::make_unique<GlassSheet>(glass, SphereMap(centre_C, semiAxes_C), mark));
    mark += 2;
  }
  const auto keep = [&](auto sheet) {
    if (sheet->inFront(near)) sheets.push_back(std::move(sheet));
  };
  for (const draw::GridPlane& plane : list.planes) keep(std::make_unique<PlaneSheet>(list.camera, plane, mark++));
  for (const draw::GlassCone& cone : list.glassCones) {
    keep(std::make_unique<ConeSheet>(list.camera, cone, mark));
    mark += 2;
  }
  for (const draw::GlassPolygon& polygon : list.glassPolygons)
    keep(std::make_unique<PolygonSheet>(list.camera, polygon, mark++));
  return sheets;
}

}  // namespace poinsot::figure
