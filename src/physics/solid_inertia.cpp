// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "physics/mass_properties.h"
#include "physics/solid_check.h"
#include "physics/solid_parts.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

Vector3d threeLengths(double M, const Vector3d& lengths_m, double n) {
  const Vector3d squares = lengths_m.cwiseAbs2();
  return M / n * Vector3d(squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]);
}

Vector3d aboutZ(double across, double along) { return {across, across, along}; }

double momentPerSquare(PolyhedronKind kind) {
  const double phi = (1 + std::sqrt(5.0)) / 2;
  switch (kind) {
    case PolyhedronKind::kTetrahedron:
      return 1.0 / 20;
    case PolyhedronKind::kCube:
      return 1.0 / 6;
    case PolyhedronKind::kOctahedron:
      return 1.0 / 10;
    case PolyhedronKind::kDodecahedron:
      return (39 * phi + 28) / 150;
    case PolyhedronKind::kIcosahedron:
      break;
  }
  return phi * phi / 10;
}

/// Principal moments about the centre of mass, in the solid's own axes, kg·m². Sources: Landau & Lifshitz,
/// Mechanics, section 32 (box, ellipsoid, cylinder, cone, rod); the others are the integrals ∫(y² + z²)dm, each
/// checked against a mesh or a sum in tests/physics/solid_test.cpp.
struct Moments {
  double M;

  Vector3d operator()(const Box& s) const { return threeLengths(M, s.edges_m, 12); }
  /// Uses (V b² - V'b'²)/(V - V') = b² + (b² - b'²) V'/(V - V'). In this form, thin walls lose no digits.
  Vector3d operator()(const HollowBox& s) const {
    const Vector3d inner = s.edges_m - Vector3d::Constant(2 * s.wall_m);
    const double ratio = volume(Box{inner}) / volume(s);
    Vector3d mean;
    for (int i = 0; i < 3; ++i)
      mean[i] = s.edges_m[i] * s.edges_m[i] + 2 * s.wall_m * (s.edges_m[i] + inner[i]) * ratio;
    return M / 12 * Vector3d(mean[1] + mean[2], mean[2] + mean[0], mean[0] + mean[1]);
  }
  Vector3d operator()(const Plate& s) const { return threeLengths(M, {s.edges_m[0], s.edges_m[1], 0}, 12); }
  Vector3d operator()(const Ellipsoid& s) const { return threeLengths(M, s.semiAxes_m, 5); }
  Vector3d operator()(const EllipsoidShell& s) const { return threeLengths(M, s.semiAxes_m, 3); }
  /// Evaluates 2(r⁵ - i⁵)/(5(r³ - i³)). Both differences are divided by r - i, so that nothing cancels.
  Vector3d operator()(const Sphere& s) const {
    const double r = s.radius_m, i = s.innerRadius_m;
    const double fourth = r * r * r * r + r * r * r * i + r * r * i * i + r * i * i * i + i * i * i * i;
    return Vector3d::Constant(M * 2 / 5 * (fourth / (r * r + r * i + i * i)));
  }
  Vector3d operator()(const SphereShell& s) const {
    return Vector3d::Constant(M * 2 / 3 * (s.radius_m * s.radius_m));
  }
  Vector3d operator()(const Hemisphere& s) const {
    const double rr = s.radius_m * s.radius_m;
    return aboutZ(M * 83 / 320 * rr, M * 2 / 5 * rr);
  }
  Vector3d operator()(const Cylinder& s) const {
    const double r = s.radius_m, i = s.innerRadius_m, h = s.height_m;
    return aboutZ(M * (3 * r * r + 3 * i * i + h * h) / 12, (M * r * r + M * i * i) / 2);
  }
  Vector3d operator()(const CylinderShell& s) const {
    const double rr = s.radius_m * s.radius_m;
    return aboutZ(M * (6 * rr + s.height_m * s.height_m) / 12, M * rr);
  }
  Vector3d operator()(const Disc& s) const {
    const double rr = s.radius_m * s.radius_m;
    return aboutZ(M * rr / 4, M * rr / 2);
  }
  Vector3d operator()(const Hoop& s) const {
    const double rr = s.radius_m * s.radius_m;
    return aboutZ(M * rr / 2, M * rr);
  }
  Vector3d operator()(const Rod& s) const {
    const double across = M * (s.length_m * s.length_m) / 12;
    return {0, across, across};
  }
  Vector3d operator()(const Cone& s) const {
    const double rr = s.radius_m * s.radius_m;
    return aboutZ(M * 3 / 80 * (4 * rr + s.height_m * s.height_m), M * 3 / 10 * rr);
  }
  Vector3d operator()(const ConeShell& s) const {
    const double rr = s.radius_m * s.radius_m;
    return aboutZ(M * (9 * rr + 2 * s.height_m * s.height_m) / 36, M * rr / 2);
  }
  Vector3d operator()(const Torus& s) const {
    const double RR = s.radius_m * s.radius_m, aa = s.tubeRadius_m * s.tubeRadius_m;
    return aboutZ(M * (4 * RR + 5 * aa) / 8, M * (4 * RR + 3 * aa) / 4);
  }
  Vector3d operator()(const TorusShell& s) const {
    const double RR = s.radius_m * s.radius_m, aa = s.tubeRadius_m * s.tubeRadius_m;
    return aboutZ(M * (2 * RR + 5 * aa) / 4, M * (2 * RR + 3 * aa) / 2);
  }
  Vector3d operator()(const Polyhedron& s) const {
    return Vector3d::Constant(M * momentPerSquare(s.kind) * (s.edge_m * s.edge_m));
  }
};

struct Centre {
  Vector3d operator()(const Hemisphere& s) const { return {0, 0, 3 * s.radius_m / 8}; }
  template <typename Other>
  Vector3d operator()(const Other&) const {
    return Vector3d::Zero();
  }
};

MassProperties combined(const std::vector<SolidPart>& pieces, double mass_kg) {
  double sum = 0;
  for (const SolidPart& piece : pieces) sum += piece.mass_kg;
  std::vector<MassProperties> placed;
  placed.reserve(pieces.size());
  for (SolidPart piece : pieces) {
    piece.mass_kg *= mass_kg / sum;
    placed.push_back(massProperties(piece));
  }
  const MassProperties whole = combined(placed);
  return {mass_kg, whole.centre_B(), whole.inertia_B()};  // the pieces' sum may differ from mass_kg by rounding
}

template <typename S>
concept MadeOfPieces = requires(const S& solid) {
  piecesOf(solid);
};

struct Properties {
  double mass_kg;

  template <typename S>
  MassProperties operator()(const S& solid) const {
    if constexpr (MadeOfPieces<S>)
      return combined(piecesOf(solid), mass_kg);
    else
      return {mass_kg, Centre{}(solid), Moments{mass_kg}(solid).asDiagonal().toDenseMatrix()};
  }
};

}  // namespace

MassProperties massProperties(const Solid& solid, double mass_kg) {
  requirePositive(mass_kg, "mass");
  requirePossible(solid);
  return std::visit(Properties{mass_kg}, solid);
}

MassProperties massProperties(const SolidPart& part) {
  return massProperties(part.solid, part.mass_kg).moved(part.q_BS, part.offset_B);
}

}  // namespace poinsot::physics
