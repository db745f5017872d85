// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/measured_body.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "scene/assembly/parts.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;

constexpr const char* kCentre = "body.centre_of_mass";
constexpr const char* kAbout = "body.moments_about";

}  // namespace

MeasuredBody::MeasuredBody(const Draft& draft, std::string way, Findings& findings)
    : draft_(draft.body),
      pivot_B_(draft.scene.body.pivot_B),
      centre_B_(draft_.centre_B),
      way_(std::move(way)),
      findings_(findings) {}

bool MeasuredBody::keysFit() {
  for (const char* path : {"body.mass", "body.pivot", kCentre, kAbout})
    if (findings_.failed(path)) return false;
  return massFits() && pointFits();
}

bool MeasuredBody::massFits() {
  if (draft_.whole.mass) return true;
  bool fits = true;
  for (const char* path : {"body.pivot", kCentre, kAbout}) {
    if (!findings_.has(path)) continue;
    fits = false;
    findings_.refuseMissing("body.mass", path,
                            fmt::format("{} (without a mass, {} is about the fixed point)", kNeedsMass, way_));
  }
  return fits;
}

bool MeasuredBody::pointFits() {
  if (draft_.momentsAbout != MomentsAbout::kPivot || pivot_B_) return true;
  findings_.refuseMissing("body.pivot", kAbout,
                          "body.pivot is missing: it is the point about which these moments are given");
  return false;
}

Vector3d MeasuredBody::point_B() const {
  switch (draft_.momentsAbout) {
    case MomentsAbout::kOrigin:
      return Vector3d::Zero();
    case MomentsAbout::kPivot:
      return *pivot_B_;
    case MomentsAbout::kCentreOfMass:
      return centre_B_;
  }
  return centre_B_;
}

std::optional<physics::MassProperties> MeasuredBody::massProperties(const Eigen::Matrix3d& inertia_B) {
  if (!draft_.whole.mass) return std::nullopt;
  try {
    return physics::MassProperties::fromInertiaAbout(point_B(), *draft_.whole.mass, centre_B_, inertia_B);
  } catch (const core::Error& error) {
    findings_.refuse(way_, contradiction(error.message()));
    return std::nullopt;
  }
}

std::string MeasuredBody::contradiction(const std::string& why) const {
  const double mass_kg = *draft_.whole.mass, distance_m = (point_B() - centre_B_).norm();
  return fmt::format(
      "the moments about {} do not fit body.mass: {:g} kg at {:g} m from there already have M d^2 = {:g} kg·m², "
      "and the remainder about the centre of mass is impossible: {}; correct the mass or the distance, or remove "
      "{} if the moments are about the centre of mass",
      draft_.momentsAbout == MomentsAbout::kPivot ? "body.pivot" : "the origin", mass_kg, distance_m,
      mass_kg * distance_m * distance_m, why, kAbout);
}

void refuseMeasuredKeys(const std::string& way, Findings& findings) {
  for (const char* path : {kCentre, kAbout})
    if (findings.has(path))
      findings.refuse(path,
                      fmt::format("belongs to a body given by inertia or principal_moments; here {} sets the "
                                  "centre of mass and the moments; leave it out",
                                  way));
}

}  // namespace poinsot::scene
