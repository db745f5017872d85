// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/piece_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "core/error.h"
#include "geometry/mesh_integrals.h"
#include "physics/transcendental.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using physics::Quaternion;

/// Returns the right-hand rotation by `angle_rad` about a nonzero axis. Does not use Eigen's rotations, because
/// they call the C library's sine, whose last bit depends on the CPU.
Quaternion turn(const Vector3d& axis, double angle_rad) {
  const Vector3d direction = axis / axis.cwiseAbs().maxCoeff();  // its squares cannot overflow
  const auto half = physics::sineCosine(angle_rad / 2);
  const double length =
      std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
  const Vector3d v = half.sine / length * direction;
  return Quaternion(half.cosine, v[0], v[1], v[2]);
}

/// Volume and mass properties of a solid or mesh, in its own axes S. The mass is still a parameter.
struct Matter {
  std::function<physics::MassProperties(double mass_kg)> massProperties;
  double volume_m3 = 0;  ///< 0 for shapes without volume: shells, plates, hoops and rods
};

Matter matterOf(const physics::Solid& solid) {
  return {[&solid](double mass_kg) { return physics::massProperties(solid, mass_kg); }, physics::volume(solid)};
}

Matter matterOf(const PointMass&) { return {}; }  // a piece with keys is never a point

void expectClosed(const geometry::Mesh& mesh) {
  try {
    geometry::checkClosed(mesh);
  } catch (const core::Error& error) {
    throw core::Error(error.kind(), error.message() +
                                        "; to only draw this mesh, give the moments as numbers in "
                                        "body.principal_moments, and the mesh in show.body.shape = \"mesh\" and "
                                        "show.body.file");
  }
}

/// Returns the volume and the mass properties of a mesh.
/// @throws core::Error if the mesh is not closed.
Matter matterOf(const std::shared_ptr<const geometry::Mesh>& mesh) {
  expectClosed(*mesh);
  const geometry::MeshIntegrals integrals = geometry::integrals(*mesh);
  return {[integrals](double mass_kg) {
            return physics::MassProperties(mass_kg, integrals.centre_M, mass_kg * integrals.inertiaPerMass_M);
          },
          integrals.volume_m3};
}

}  // namespace

bool PieceReader::massFits() {
  if (has("mass") && has("density")) {
    findings_.refuse(path("density"), fmt::format("{} is given too; give one of the two", path("mass")));
    return false;
  }
  if (!has("mass") && !has("density")) {
    if (!findings_.misspelt(path("density")))
      findings_.refuseMissing(path("mass"), has("shape") ? path("shape") : lengthPath(),
                              fmt::format("{} is missing: a shape and its mass (or density) set the moments "
                                          "together. For example:\n    mass = 1",
                                          path("mass")));
    return false;
  }
  return piece_.mass || piece_.density;
}

std::optional<double> PieceReader::mass(double volume_m3) {
  if (piece_.mass) return piece_.mass;
  if (volume_m3 == 0) {
    findings_.refuse(
        path("density"),
        fmt::format("this shape has no volume, so a density does not determine its mass; give {}", path("mass")));
    return std::nullopt;
  }
  return *piece_.density * volume_m3;
}

std::optional<Quaternion> PieceReader::turnAboutAxis() {
  if (!has("axis") || !has("angle")) {
    const char *present = has("axis") ? "axis" : "angle", *missing = has("axis") ? "angle" : "axis";
    findings_.refuseMissing(path(missing), path(present),
                            fmt::format("{} is missing: a turn is an axis and an angle", path(missing)));
    return std::nullopt;
  }
  if (!piece_.axis || !piece_.angle) return std::nullopt;
  if (piece_.axis->isZero(0)) {
    findings_.refuse(path("axis"), "must not be zero, got (0, 0, 0): a zero vector is not an axis");
    return std::nullopt;
  }
  return turn(*piece_.axis, *piece_.angle);
}

std::optional<Quaternion> PieceReader::rotation() {
  const bool axisAngle = has("axis") || has("angle");
  if (has("rotation") && axisAngle) {
    const std::string other = path(has("axis") ? "axis" : "angle");
    findings_.refuse(other, fmt::format("{} is given too; give rotation, or axis and angle", path("rotation")));
    return std::nullopt;
  }
  if (axisAngle) return turnAboutAxis();
  if (has("rotation")) return piece_.rotation;
  return Quaternion::Identity();
}

std::optional<Part> PieceReader::massless() {
  if (!shape_.given()) {
    findings_.refuseMissing(path("shape"), table_, fmt::format("{} is missing", path("shape")));
    return std::nullopt;
  }
  const auto figure = shape_.figure();
  const auto q_BS = rotation();
  if (!figure || !q_BS || (has("offset") && !piece_.offset)) return std::nullopt;
  Part part = asPart(*figure);
  part.q_BS = *q_BS;
  part.offset_B = piece_.offset.value_or(Vector3d::Zero());
  return part;
}

std::optional<Piece> PieceReader::withMass(Part part) {
  const Matter matter = std::visit([](const auto& kind) { return matterOf(kind); }, part.figure);
  const auto mass_kg = mass(matter.volume_m3);
  if (!mass_kg) return std::nullopt;
  part.mass_kg = *mass_kg;
  return Piece{part, matter.massProperties(*mass_kg).moved(part.q_BS, part.offset_B)};
}

std::optional<Piece> PieceReader::piece() {
  auto part = massless();
  if (!shape_.given()) return std::nullopt;
  if (!massFits() || !part) return std::nullopt;
  try {
    return withMass(std::move(*part));
  } catch (const core::Error& error) {
    findings_.refuse(lengthPath(), error.message());
    return std::nullopt;
  }
}

std::optional<Piece> pointMass(const PointDraft& point, const std::string& table, Findings& findings) {
  for (const char* name : {".mass", ".position"})
    if (!findings.has(table + name))
      findings.refuseMissing(table + name, table,
                             fmt::format("{}{} is missing: a point mass has mass and position", table, name));
  if (!point.mass || !point.position) return std::nullopt;
  return Piece{{PointMass{}, *point.mass, Quaternion::Identity(), *point.position},
               physics::MassProperties::ofPoint(*point.mass, *point.position)};
}

}  // namespace poinsot::scene
