// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>

#include "core/abi.h"

namespace poinsot::scene {

/// Direction that can be one side of an angle in a scene.
enum class Direction { kL, kOmega, kTorque, kAxis, kE1, kE2, kE3, kX, kY, kZ };

enum class VectorFrame {
  kSpace,
  kBody,
  kPrincipal,
  kPrecession,  ///< axes i, j, k of a free symmetric top, with i in the plane of L and k
  kOwn,         ///< [body.own_axes]
};

/// Quantity or role that determines the colour of a vector.
enum class Meaning { kVector, kInk, kL, kOmega, kBody, kAxis, kTorque };

/// Vector with constant components in one frame.
struct FixedVector {
  Eigen::Vector3d components = Eigen::Vector3d::UnitX();  ///< only the direction is used, not the length
  VectorFrame frame = VectorFrame::kSpace;
};

/// Vector from the fixed point to a point of the drawn body.
struct PositionVector {
  Eigen::Vector3d point_B;  ///< position of the point, m
};

/// Velocity omega x r of a point of the body. The vector begins at that point.
struct VelocityVector {
  Eigen::Vector3d point_B;  ///< position of the point, m
};

struct NamedVector {
  std::variant<FixedVector, PositionVector, VelocityVector> what;
  std::string name;  ///< name in the TeX subset of the text library
  double scale = 1;
  Meaning color = Meaning::kVector;
};

struct NamedAngle {
  Direction from = Direction::kL, to = Direction::kAxis;
  std::string name;
  double scale = 1;
};

static_assert(core::laidOut<FixedVector, 32>() && core::laidOut<PositionVector, 24>() &&
              core::laidOut<VelocityVector, 24>());

}  // namespace poinsot::scene
