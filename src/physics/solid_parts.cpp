// SPDX-License-Identifier: Apache-2.0
#include "physics/solid_parts.h"

#include "physics/solid_check.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

// Rotations whose quaternions are exact in doubles.
const Quaternion kUnturned(1, 0, 0, 0);
const Quaternion kZtoX(.5, .5, .5, .5);
const Quaternion kZtoY(.5, -.5, -.5, -.5);
const Quaternion kUpsideDown(0, 1, 0, 0);

// Masses of a racket's hoop and handle, in units of 0.01 kg. Only their ratio matters.
constexpr double kHoopShare = 17, kHandleShare = 16;

/// Returns a part whose mass equals its volume, for bodies of uniform density.
SolidPart ofVolume(const Solid& solid, const Quaternion& q_BS, const Vector3d& offset_B) {
  return {solid, volume(solid), q_BS, offset_B};
}

SolidPart ofArea(const Plate& plate, const Vector3d& offset_B) {
  return {plate, plate.edges_m[0] * plate.edges_m[1], kUnturned, offset_B};
}

std::vector<SolidPart> withMass(std::vector<SolidPart> parts, double mass_kg) {
  double sum = 0;
  for (const SolidPart& part : parts) sum += part.mass_kg;
  for (SolidPart& part : parts) part.mass_kg = mass_kg * (part.mass_kg / sum);
  return parts;
}

}  // namespace

std::vector<SolidPart> piecesOf(const Capsule& solid) {
  const Hemisphere end{solid.radius_m};
  const double end_z = solid.height_m / 2;
  return {ofVolume(Cylinder{solid.radius_m, solid.height_m}, kUnturned, {0, 0, 0}),
          ofVolume(end, kUnturned, {0, 0, end_z}), ofVolume(end, kUpsideDown, {0, 0, -end_z})};
}

std::vector<SolidPart> piecesOf(const LPlate& solid) {
  const double x = solid.edges_m[0], rest = solid.edges_m[1] - solid.arm_m, w = solid.arm_m;
  return {ofArea({{x, w}}, {x / 2, w / 2, 0}), ofArea({{w, rest}}, {w / 2, w + rest / 2, 0})};
}

std::vector<SolidPart> piecesOf(const THandle& solid) {
  const Cylinder bar{solid.barRadius_m, solid.barLength_m}, shaft{solid.shaftRadius_m, solid.shaftLength_m};
  return {ofVolume(bar, kZtoX, {0, 0, 0}), ofVolume(shaft, kZtoY, {0, bar.radius_m + shaft.height_m / 2, 0})};
}

std::vector<SolidPart> piecesOf(const Racket& solid) {
  const double handle_m = solid.length_m - solid.width_m;
  return {{Hoop{solid.width_m / 2}, kHoopShare, kUnturned, {0, 0, 0}},
          {Rod{handle_m}, kHandleShare, kUnturned, {-(solid.width_m + handle_m) / 2, 0, 0}}};
}

std::vector<SolidPart> piecesOf(const WingNut& solid) {
  const Box wing{solid.wing_m};
  const double x = solid.wingCentre_m, z = solid.wingRise_m;
  return {ofVolume(Cylinder{solid.hubRadius_m, solid.hubHeight_m}, kUnturned, {0, 0, 0}),
          ofVolume(wing, kUnturned, {x, 0, z}), ofVolume(wing, kUnturned, {-x, 0, z})};
}

namespace {

struct Parts {
  double mass_kg;

  template <typename Composite>
  std::vector<SolidPart> of(const Composite& solid) const {
    return withMass(piecesOf(solid), mass_kg);
  }
  std::vector<SolidPart> operator()(const LPlate& solid) const { return of(solid); }
  std::vector<SolidPart> operator()(const THandle& solid) const { return of(solid); }
  std::vector<SolidPart> operator()(const Racket& solid) const { return of(solid); }
  std::vector<SolidPart> operator()(const WingNut& solid) const { return of(solid); }
  template <typename Simple>
  std::vector<SolidPart> operator()(const Simple& solid) const {
    return {{solid, mass_kg, kUnturned, Vector3d::Zero()}};
  }
};

}  // namespace

std::vector<SolidPart> partsOf(const Solid& solid, double mass_kg) {
  requirePositive(mass_kg, "mass");
  requirePossible(solid);
  return std::visit(Parts{mass_kg}, solid);
}

}  // namespace poinsot::physics
