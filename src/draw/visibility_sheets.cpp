// SPDX-License-Identifier: Apache-2.0
// The opacities are those of composite.frag, without the lines.
#include "draw/visibility_sheets.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "draw/visibility.h"

namespace poinsot::draw {
namespace {

std::uint64_t bit(std::size_t index) { return index < 64 ? std::uint64_t{1} << index : 0; }

class GlassSheet : public Sheet {
 public:
  GlassSheet(const GlassEllipsoid& glass, const SphereMap& sphere, std::size_t firstMark)
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
    const double facing = std::abs(glm::dot(sphere_.normal_C(sight, at), glm::normalize(sight.direction_C)));
    const double grazing = (1 - facing) * (1 - facing) * (1 - facing);
    const double opacity = glm::mix(static_cast<double>(flatOn), static_cast<double>(glass_.rimOpacity), grazing);
    hits.push_back({at, opacity, glass_.color, bit(mark)});
  }

  GlassEllipsoid glass_;
  SphereMap sphere_;
  std::size_t firstMark_;
};

class PlaneSheet : public Sheet {
 public:
  PlaneSheet(const Camera& camera, const GridPlane& plane, std::size_t mark)
      : plane_(plane),
        centre_C_(toCameraExactly(camera, plane.centre_W)),
        u_C_(turnToCamera(camera, plane.u_W)),
        v_C_(turnToCamera(camera, plane.v_W)),
        shadowCentre_C_(toCameraExactly(camera, plane.shadowCentre_W)),
        mark_(mark) {}

  bool inFront(double near) const {
    const double reach = std::abs(u_C_.z) + std::abs(v_C_.z);
    return -centre_C_.z - reach > near;
  }

  void meet(const SightLine& sight, double t, std::vector<SheetHit>& hits) const override {
    const glm::dvec3 normal = glm::cross(u_C_, v_C_);
    const double at = glm::dot(normal, centre_C_) / glm::dot(normal, sight.direction_C);
    if (!(at > 0 && at < t)) return;
    const glm::dvec3 x = at * sight.direction_C - centre_C_;
    const auto share = [&](const glm::dvec3& edge) { return glm::dot(x, edge) / glm::dot(edge, edge); };
    if (std::abs(share(u_C_)) > 1 || std::abs(share(v_C_)) > 1) return;
    const glm::dvec3 fromShadow = at * sight.direction_C - shadowCentre_C_;
    hits.push_back(shaded(at, glm::cross(fromShadow, glm::normalize(normal))));
  }

 private:
  // The shadow lies over the sheet's own tint. `fromShadow` may be turned: only its length counts.
  SheetHit shaded(double t, const glm::dvec3& fromShadow) const {
    const double r = static_cast<double>(plane_.shadowRadius_W), tint = static_cast<double>(plane_.opacity);
    const double q = r > 0 ? glm::dot(fromShadow, fromShadow) / (r * r) : 1e9;
    const double dark = static_cast<double>(plane_.shadowOpacity) * std::exp2(-2 * q);
    const double opacity = dark + tint * (1 - dark);
    const float share = opacity > 0 ? static_cast<float>(dark / opacity) : 0;
    return {t, opacity, share * Color(0.02f) + (1 - share) * plane_.color, bit(mark_)};
  }

  GridPlane plane_;
  glm::dvec3 centre_C_, u_C_, v_C_, shadowCentre_C_;
  std::size_t mark_;
};

}  // namespace

std::vector<std::unique_ptr<const Sheet>> sheetsOf(const DrawList& list) {
  std::vector<std::unique_ptr<const Sheet>> sheets;
  std::size_t mark = 0;
  for (const GlassEllipsoid& glass : list.glassEllipsoids) {
    const glm::dvec3 centre_C = toCameraExactly(list.camera, glass.centre_W);
    const glm::dmat3 semiAxes_C = turnToCamera(list.camera, glass.semiAxes_W);
    if (inFront(list.camera, centre_C, semiAxes_C))
      sheets.push_back(std::make_unique<GlassSheet>(glass, SphereMap(centre_C, semiAxes_C), mark));
    mark += 2;
  }
  for (const GridPlane& plane : list.planes) {
    auto sheet = std::make_unique<PlaneSheet>(list.camera, plane, mark++);
    if (sheet->inFront(static_cast<double>(list.camera.near))) sheets.push_back(std::move(sheet));
  }
  return sheets;
}

}  // namespace poinsot::draw
