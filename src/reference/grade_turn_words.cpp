// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_turn_words.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>

namespace poinsot::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using physics::Quaternion;

/// Common name for an exchange of axes, the same for body and space. `mapping` gives the scene's x, y, z in terms
/// of the log's axes. Some names contain "mirrored", because a mirror and a rotation have the same effect
/// (grade_turn.h).
struct KnownAxes {
  std::string_view mapping, name;
};

constexpr KnownAxes kKnownAxes[] = {
    {"x, -y, -z", "forward-right-down axes"},
    {"-x, y, -z", "left-handed axes (Unreal), as if the y axis were mirrored"},
    {"-x, -y, z", "left-handed axes (Unity), as if the z axis were mirrored"},
    {"-x, -z, -y", "left-handed axes with y up (Unity), as if y and z were exchanged"},
    {"y, x, -z", "north-east-down and east-north-up axes"},
    {"x, -z, y", "axes with y up"},
    {"x, z, -y", "axes with z up, where the scene has y up"},
};

/// Returns the scene's axes in terms of the log's axes, such as "x, -y, -z". Empty if the rotation does more than
/// exchange or reverse axes.
std::string mappingOf(const Quaternion& toScene) {
  const Matrix3d m = toScene.toRotationMatrix();
  std::string mapping;
  for (int row = 0; row < 3; ++row) {
    Eigen::Index axis = 0;
    if (m.row(row).cwiseAbs().maxCoeff(&axis) < 1 - 1e-9) return "";
    mapping += fmt::format("{}{}{}", row > 0 ? ", " : "", m(row, axis) < 0 ? "-" : "", "xyz"[axis]);
  }
  return mapping;
}

/// Returns "x" for (1, 0, 0), and so on. For an axis between the coordinate axes, returns its components.
std::string axisText(const Vector3d& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] > 1 - 1e-9) return std::string(1, "xyz"[largest]);
  const auto rounded = [](double v) { return std::round(v * 1e3) / 1e3 + 0.; };
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", rounded(axis[0]), rounded(axis[1]), rounded(axis[2]));
}

/// Returns the angle and the axis of a rotation as text. The angle is at most 180 deg. At 180 deg, the first
/// nonzero component of the axis is positive.
std::string turnText(const Quaternion& turn) {
  Vector3d axis = (turn.w() < 0 ? -1 : 1) * turn.vec().normalized();
  if (std::abs(turn.w()) < 1e-9)
    for (const double component : {axis[0], axis[1], axis[2]})
      if (std::abs(component) > 1e-9) {
        axis *= component < 0 ? -1 : 1;
        break;
      }
  return fmt::format("{:.4g} deg about {}", angleOf(turn) * 180 / EIGEN_PI, axisText(axis));
}

std::string remarkOn(TurnedAxes axes, const Quaternion& toScene, std::string_view formula) {
  const std::string mapping = mappingOf(toScene);
  if (mapping.empty()) return std::string(formula);
  const std::string remark = "the scene's x, y, z are the log's " + mapping;
  if (axes == TurnedAxes::kBoth)
    for (const KnownAxes& known : kKnownAxes)
      if (known.mapping == mapping) return fmt::format("{}; {}", known.name, remark);
  return remark;
}

}  // namespace

double angleOf(const Quaternion& turn) { return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w())); }

FitCause turnCause(TurnedAxes axes, const Quaternion& toScene) {
  struct Words {
    std::string_view subject, formula;
  };
  const Words words[] = {
      {"both frames are", "turn q turn^-1, and turn omega"},
      {"the body's axes are", "q turn, and turn^-1 omega_B"},
      {"the axes of space are", "turn q, and turn omega_W, L_W"},
      {"the body's axes of q, not of omega, are", "q turn"},
      {"the axes of space of q, not of omega, are", "turn q"},
      {"the axes of omega are", "turn omega"},
  };
  const auto& [subject, formula] = words[static_cast<std::size_t>(axes)];
  // With the scene's axes, the attitude is space q body^-1, so a rotation of the body's axes is to the right of q.
  const bool onTheRight = axes == TurnedAxes::kBody || axes == TurnedAxes::kBodyOfAttitude;
  return {
      fmt::format("{} turned by {}", subject, turnText(onTheRight ? Quaternion(toScene.conjugate()) : toScene)),
      remarkOn(axes, toScene, formula)};
}

}  // namespace poinsot::reference
