// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/polhode_cones_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "physics/herpolhode.h"
#include "physics/poinsot_construction.h"
#include "physics/polhode.h"
#include "stage/figures/cones_figure.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// Lines along the sides of a cone, of which every third is strong, and points of a rim. The lines alone draw the
// surface: as many sheets of glass as the cones need would take minutes for a picture.
constexpr int kSideLines = 96, kStrongLines = 3, kPointsPerLine = 4, kFramedCircle = 24;
constexpr double kFineWidth = 0.6, kStrongWidth = 0.9;
constexpr double kPathWidth = 1.1, kRimLift = 0.012;  // lifted over the path, part of which the rim covers

void requireCones(const PictureMotion& motion, const physics::Polhode& polhode) {
  const auto refuse = [](const char* why) {
    return core::sceneError(fmt::format("show.cones.visible: {}; leave it out", why));
  };
  if (!motion.isFree()) throw refuse("cones exist only if nothing acts on the body");
  if (polhode.regime() == physics::PolhodeRegime::kSteady) throw refuse("the rotation is steady");
  if (polhode.regime() == physics::PolhodeRegime::kSeparatrix) throw refuse("the motion is on the separatrix");
}

/// Adds the lines along a cone's sides that end on its rim. Fine lines are as strong as a sheet of glass that is
/// seen twice.
void addSideLines(const Canvas& canvas, const std::vector<Vector3d>& rim_V, const draw::Color& color,
                  double opacity) {
  const draw::Color fine = mixed(color, canvas.colors.paper, static_cast<double>(canvas.glass(opacity, 2))),
                    strong = mixed(color, canvas.colors.paper, ConeLook::kLineShare);
  for (std::size_t i = 0; i * kPointsPerLine < rim_V.size(); ++i) {
    const Vector3d& onRim = rim_V[i * kPointsPerLine];
    const bool isStrong = i % kStrongLines == 0;
    canvas.line({ConeLook::kInside * onRim, onRim}, false, isStrong ? strong : fine,
                isStrong ? kStrongWidth : kFineWidth);
  }
}

// Writes the name beside the point of the rim that is farthest from the other cone.
void addName(const Canvas& canvas, const std::vector<Vector3d>& rim_V, const Vector3d& omega_V,
             scene::LabelName name, const draw::Color& color) {
  const auto farthest =
      std::ranges::min_element(rim_V, {}, [&](const Vector3d& p) { return p.normalized().dot(omega_V); });
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : rim_V) middle += p / static_cast<double>(rim_V.size());
  canvas.label(name, *farthest, middle, color, ConeLook::kNameSize);
}

}  // namespace

PolhodeConesFigure::PolhodeConesFigure(const Setting& setting)
    : motion_(setting.motion),
      side_(ConeLook::kSide * setting.scene.show.figures.cones.scale * setting.scales.omega),
      opacity_(setting.scene.show.figures.cones.opacity) {
  const physics::PrincipalMoments& moments = motion_.moments();
  const Vector3d omega_P = motion_.liveliest().omega_P;
  const physics::Polhode polhode(moments, omega_P);
  requireCones(motion_, polhode);
  for (const auto& sample : polhode.samples(kSideLines * kPointsPerLine)) polhode_P_.push_back(sample.omega_P);
  const physics::Herpolhode herpolhode(moments, omega_P);
  turn_s_ = 2 * std::numbers::pi * herpolhode.radialPeriod() / herpolhode.anglePerRadialPeriod();
  height_ = side_ * physics::PoinsotConstruction(moments, omega_P).planeHeight();
  outerRadius_ = side_ * herpolhode.largestRadius();
}

std::vector<Vector3d> PolhodeConesFigure::bodyRim_V(const PictureState& state) const {
  std::vector<Vector3d> rim;
  for (const Vector3d& p : polhode_P_) rim.emplace_back(side_ * (state.R_VP * p));
  return rim;
}

// The points are at times that all frames have in common, so that lines on the cone stand still.
std::vector<Vector3d> PolhodeConesFigure::spaceRim_V(double filmTime_s, const PictureState& state) const {
  const double now_s = motion_.motionTimeOf(motion_.played_s(filmTime_s));
  const double step_s = turn_s_ / kSideLines;
  const double first = kStrongLines * std::ceil((now_s - 0.5 * turn_s_) / (kStrongLines * step_s));
  std::vector<Vector3d> rim;
  for (int i = 0; i <= (kSideLines - kStrongLines) * kPointsPerLine; ++i)
    rim.emplace_back(side_ * (state.R_VW * motion_.omegaAtMotionTime_W(
                                               (first + static_cast<double>(i) / kPointsPerLine) * step_s)));
  return rim;
}

void PolhodeConesFigure::addPath(const Canvas& canvas, const PictureState& state, double from_s,
                                 double to_s) const {
  if (!(to_s > from_s)) return;
  std::vector<Vector3d> points_V;
  for (const PathPoint& p : motion_.path(from_s, to_s)) points_V.push_back(side_ * (state.R_VW * p.omega_W));
  canvas.line(points_V, false, mixed(canvas.colors.spaceCone, canvas.colors.paper, ConeLook::kLineShare),
              kPathWidth);
}

void PolhodeConesFigure::add(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  const std::vector<Vector3d> body = bodyRim_V(state), space = spaceRim_V(filmTime_s, state);
  const Trail trail = motion_.trail(filmTime_s, motion_.longestPath_s());
  addPath(canvas, state, trail.from, trail.now);
  addPath(canvas, state, trail.now, trail.end);
  const draw::Color &ofSpace = canvas.colors.spaceCone, &ofBody = canvas.colors.bodyCone;
  addSideLines(canvas, space, ofSpace, opacity_);
  addSideLines(canvas, body, ofBody, opacity_);
  canvas.line(space, false, ofSpace, ConeLook::kRimWidth, kRimLift);
  canvas.line(body, true, ofBody, ConeLook::kRimWidth, kRimLift);
  addName(canvas, space, state.omega_V, scene::LabelName::kSpaceCone, ofSpace);
  addName(canvas, body, state.omega_V, scene::LabelName::kBodyCone, ofBody);
}

// The space cone lies inside the circular cone through the largest circle that the herpolhode touches.
std::vector<Vector3d> PolhodeConesFigure::outermostPoints(const PictureState& state) const {
  const Vector3d l = state.L_V.normalized();
  std::vector<Vector3d> points = circleAbout(height_ * l, l, outerRadius_, kFramedCircle);
  for (std::size_t i = 0; i < polhode_P_.size(); i += kPointsPerLine)
    points.emplace_back(side_ * (state.R_VP * polhode_P_[i]));
  return points;
}

}  // namespace poinsot::stage
