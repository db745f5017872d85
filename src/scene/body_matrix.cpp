// SPDX-License-Identifier: Apache-2.0
#include "scene/body_matrix.h"

#include "core/expect.h"
#include "physics/inertia_tensor.h"

namespace poinsot::scene {
namespace {

using enum BodyMatrix;

/// Returns the matrix U whose rows are the axes A, along B: it turns components along B to components along A.
Eigen::Matrix3d turnMatrix(const physics::Quaternion& q_BA) {
  Eigen::Matrix3d U;
  for (int axis = 0; axis < 3; ++axis) U.row(axis) = physics::turnedVector(q_BA, Eigen::Vector3d::Unit(axis));
  return U;
}

Eigen::Matrix3d principalMatrix(const Body& body) {
  Eigen::Matrix3d U;
  for (int axis = 0; axis < 3; ++axis) U.row(axis) = body.axes.toB(Eigen::Vector3d::Unit(axis));
  return U;
}

/// Returns M(a² 1 - a a), which is the tensor of a point mass at a (eq 14).
Eigen::Matrix3d displacement(const Body& body) {
  const Eigen::Vector3d a = body.fixedPoint_B() - body.mass->centre_B();
  return physics::MassProperties::ofPoint(body.mass->mass_kg(), a).inertiaAbout(Eigen::Vector3d::Zero());
}

}  // namespace

std::vector<std::string_view> bodyMatrixWords() {  // names of the enumerators of BodyMatrix, in their order
  return {"inertia",     "inertia_centre", "inertia_displacement", "inertia_principal", "U_principal",
          "inertia_own", "U_own"};
}

std::string_view bodyMatrixTex(const Body& body, BodyMatrix matrix) {
  switch (matrix) {
    case kInertia:
      break;
    case kInertiaCentre:
      return "I_{\\mathrm{cm}}";
    case kInertiaDisplacement:
      return "M(a^2\\delta_{\\alpha\\beta} - a_\\alpha a_\\beta)";
    case kInertiaPrincipal:
      return "U_{\\mathrm{P}}\\,I\\,\\tilde{U}_{\\mathrm{P}}";
    case kUPrincipal:
      return "U_{\\mathrm{P}}";
    case kInertiaOwn:
      return "I' = U I\\,\\tilde{U}";
    case kUOwn:
      return "U";
  }
  return body.pivot_B ? "I_{\\mathrm{pivot}}" : "I";
}

bool isTensor(BodyMatrix matrix) { return matrix != kUPrincipal && matrix != kUOwn; }

std::string lackFor(const Body& body, BodyMatrix matrix) {
  if ((matrix == kInertiaOwn || matrix == kUOwn) && !body.q_BA)
    return "needs axes of one's own; give [body.own_axes]";
  if ((matrix == kInertiaCentre || matrix == kInertiaDisplacement) && !body.mass)
    return "needs a body with a mass; give body.mass in addition to the moments of inertia";
  if (matrix == kInertiaDisplacement && !body.pivot_B)
    return "needs a point other than the centre of mass; give body.pivot";
  return "";
}

Eigen::Matrix3d bodyMatrix(const Body& body, BodyMatrix matrix) {
  POINSOT_EXPECT(lackFor(body, matrix).empty());
  switch (matrix) {
    case kInertia:
      break;
    case kInertiaCentre:
      return body.mass->inertia_B();
    case kInertiaDisplacement:
      return displacement(body);
    case kInertiaPrincipal:
      return body.axes.moments().values().asDiagonal();
    case kUPrincipal:
      return principalMatrix(body);
    case kInertiaOwn:
      return physics::turnedTensor(body.q_BA->conjugate(), body.axes.inertia_B());
    case kUOwn:
      return turnMatrix(*body.q_BA);
  }
  return body.axes.inertia_B();
}

}  // namespace poinsot::scene
