// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "figure/visibility_sheets.h"
#include "figure/visibility_solids.h"

namespace poinsot::figure {
namespace {

// Relative tolerance of depth. Without it, a point on a surface with rounded coordinates could be hidden by the
// surface.
constexpr double kOnSurface = 1e-6;

void lookThrough(std::vector<SheetHit> hits, Sight& sight) {
  std::ranges::sort(hits, {}, &SheetHit::t);
  for (const SheetHit& hit : hits) {
    sight.veil += sight.transmittance * hit.opacity * glm::dvec3(hit.color);
    sight.transmittance *= 1 - hit.opacity;
    sight.sheets |= hit.mark;
  }
}

}  // namespace

struct Visibility::Scene {
  draw::Camera camera;
  std::vector<std::unique_ptr<const Occluder>> occluders;
  std::vector<std::unique_ptr<const Sheet>> sheets;
};

Visibility::Visibility(const draw::DrawList& list)
    : scene_(std::make_unique<const Scene>(Scene{list.camera, occludersOf(list), sheetsOf(list)})) {}
Visibility::~Visibility() = default;
Visibility::Visibility(Visibility&&) noexcept = default;

Sight Visibility::of(glm::dvec3 point_V, double lift_V) const {
  const glm::dvec3 p_C = toCameraExactly(scene_->camera, point_V);
  const SightLine line =
      scene_->camera.orthographic ? SightLine{{p_C.x, p_C.y, 0}, {0, 0, -1}} : SightLine{{0, 0, 0}, p_C / -p_C.z};
  const double t = -p_C.z * (1 - kOnSurface) - lift_V;
  Sight sight;
  sight.hidden = std::ranges::any_of(scene_->occluders, [&](const auto& o) { return o->hides(line, t); });
  if (sight.hidden) return sight;
  std::vector<SheetHit> hits;
  for (const auto& sheet : scene_->sheets) sheet->meet(line, t, hits);
  lookThrough(std::move(hits), sight);
  return sight;
}

glm::dvec3 toCameraExactly(const draw::Camera& camera, glm::dvec3 point_V) {
  return (point_V - glm::dvec3(camera.eye_V)) * glm::dmat3(camera.R_VC);
}

glm::dvec2 projectExactly(const draw::Camera& camera, glm::dvec3 point_C) {
  const double focal_px = static_cast<double>(camera.focal_px());
  const double scale = camera.orthographic ? focal_px : focal_px / -point_C.z;
  return glm::dvec2(camera.centre_px) + scale * glm::dvec2(point_C.x, -point_C.y);
}

}  // namespace poinsot::figure
