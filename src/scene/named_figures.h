// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>

#include "core/abi.h"

/// Vectors and angles that a scene adds to its pictures.
namespace poinsot::scene {

/// A direction that a picture has already.
enum class Direction { kL, kOmega, kTorque, kAxis, kE1, kE2, kE3, kX, kY, kZ };

enum class VectorFrame { kSpace, kBody, kPrincipal };

/// Whose colour a vector has.
enum class Meaning { kVector, kInk, kL, kOmega, kBody, kAxis, kTorque };

/// Fixed in its axes.
struct FixedVector {
  Eigen::Vector3d components = Eigen::Vector3d::UnitX();  ///< only the direction counts
  VectorFrame frame = VectorFrame::kSpace;
};

/// From the fixed point to a point of the body, as the body is drawn.
struct PositionVector {
  Eigen::Vector3d point_B;  ///< m
};

/// omega x r of a point of the body, at the point.
struct VelocityVector {
  Eigen::Vector3d point_B;  ///< m
};

struct NamedVector {
  std::variant<FixedVector, PositionVector, VelocityVector> what;
  std::string name;  ///< the TeX subset of text/
  double scale = 1;
  Meaning color = Meaning::kVector;
};

struct NamedAngle {
  Direction from = Direction::kL, to = Direction::kAxis;
  std::string name;  ///< the TeX subset of text/
  double scale = 1;
};

static_assert(core::laidOut<FixedVector, 32>() && core::laidOut<PositionVector, 24>() &&
              core::laidOut<VelocityVector, 24>());

}  // namespace poinsot::scene
