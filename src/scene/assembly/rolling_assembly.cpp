// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "core/error.h"
#include "scene/assembly/parts.h"
#include "scene/keys/start_ways.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;

/// Cone as a part of a body: its size, and its apex and axis in the body's axes.
struct ConePart {
  double radius_m = 0, height_m = 0;
  Vector3d apex_B, axis_B;
};

/// Returns a solid cone or its side, if the body is one of these; otherwise nullopt.
std::optional<ConePart> conePart(const Body& body) {
  const auto* solid = body.parts.size() == 1 ? std::get_if<physics::Solid>(&body.parts[0].figure) : nullptr;
  if (!solid) return std::nullopt;
  const Part& part = body.parts[0];
  const auto placed = [&](double radius_m, double height_m, double apex) {
    return ConePart{radius_m, height_m, part.offset_B + part.q_BS * Vector3d(0, 0, apex * height_m),
                    part.q_BS * -Vector3d::UnitZ()};
  };
  if (const auto* cone = std::get_if<physics::Cone>(solid)) return placed(cone->radius_m, cone->height_m, 3.0 / 4);
  if (const auto* side = std::get_if<physics::ConeShell>(solid))
    return placed(side->radius_m, side->height_m, 2.0 / 3);
  return std::nullopt;
}

std::string numbers(const Vector3d& v) {
  const auto number = [](double value) { return std::abs(value) < 1e-15 ? 0.0 : value; };
  return fmt::format("[{:.10g}, {:.10g}, {:.10g}]", number(v[0]), number(v[1]), number(v[2]));
}

std::string rateText(double rate) {
  return fmt::format("{:.6g} rad/s ({:.6g} rpm)", rate, rate * 30 / std::numbers::pi);
}

class RollingAssembly {
 public:
  RollingAssembly(const Draft& draft, const Body* body, Findings& findings, Motion& motion)
      : draft_(draft.rolling), body_(body), findings_(findings), motion_(motion) {}

  void run() {
    motion_.omega_B = Vector3d::Ones();  // nonzero, so that a rejected cone is not taken for rest
    if (!isAlone() || !hasRate() || !body_) return;
    const auto part = conePart(*body_);
    if (!part)
      findings_.refuse(
          "motion.rolling",
          "only a cone rolls on a table: the body must be one shape \"cone\" or \"cone_shell\"; change "
          "body.shape, or leave out [motion.rolling]");
    else if (pivotIsApex(*part))
      roll(*part);
  }

 private:
  /// Checks that nothing else gives the motion.
  bool isAlone() {
    for (const char* path :
         {"motion.gravity", "motion.torque", "motion.drag", "motion.dissipation", "motion.flight", "motion.force"})
      if (findings_.hasTable(path) || findings_.count(path) > 0) return refuseSecond(path);
    for (const StartWay& way : startWays())
      for (const std::string_view name : way.keys) {
        const std::string path =
            fmt::format("motion.{}", name.ends_with('.') ? name.substr(0, name.size() - 1) : name);
        if (name.ends_with('.') ? findings_.hasBelow(path) : findings_.has(path)) return refuseSecond(path);
      }
    return !findings_.has("motion.L_points") || refuseSecond("motion.L_points");
  }

  bool refuseSecond(const std::string& path) {
    findings_.refuse(path,
                     "motion.rolling is given too, and a rolling cone has no other start or torque; leave out "
                     "one of the two");
    return false;
  }

  bool hasRate() {
    if (!findings_.has("motion.rolling.rate"))
      findings_.refuseMissing(
          "motion.rolling.rate", "motion.rolling",
          "motion.rolling.rate is missing: give the rate about the vertical, such as \"12 rpm\"");
    return draft_.rate && !findings_.failed("motion.rolling.g");
  }

  bool pivotIsApex(const ConePart& part) {
    constexpr double kRounded = 1e-6;  // allowed distance from the apex, relative to the height
    if (findings_.failed("body.pivot")) return false;
    const std::string apex = numbers(part.apex_B);
    if (!body_->pivot_B)
      findings_.refuseMissing(
          "body.pivot", "motion.rolling",
          fmt::format("body.pivot is missing: a cone rolls about its apex; give body.pivot = {}", apex));
    else if ((*body_->pivot_B - part.apex_B).norm() > kRounded * part.height_m)
      findings_.refuse("body.pivot",
                       fmt::format("a rolling cone turns about its apex, which is at {} m; got {} m; "
                                   "give body.pivot = {}",
                                   apex, numbers(*body_->pivot_B), apex));
    else
      return true;
    return false;
  }

  void roll(const ConePart& part) {
    Rolling rolling;
    rolling.g = draft_.g.value_or(rolling.g);
    rolling.centre_m = (body_->mass->centre_B() - part.apex_B).norm();
    try {
      rolling.cone = physics::rollingCone(body_->axes, part.axis_B, part.radius_m, part.height_m, *draft_.rate);
    } catch (const core::Error& error) {
      return findings_.refuse("motion.rolling.rate", error.message());
    }
    const physics::RollingForces forces =
        physics::rollingForces(rolling.cone, body_->mass->mass_kg(), rolling.centre_m, rolling.g);
    if (!forces.holds(rolling.cone))
      return findings_.refuse(
          "motion.rolling.rate",
          fmt::format("at {} this cone tips over the rim of its base; at most {} is possible; give a smaller rate",
                      rateText(rolling.cone.rate), rateText(forces.fastest)));
    const physics::RigidBodyState start = physics::RollingMotion(body_->axes, rolling.cone).at(0);
    motion_.omega_B = start.omega_B;
    motion_.orientation_WB = start.q_WB;
    motion_.rolling = rolling;
  }

  const RollingDraft& draft_;
  const Body* body_;
  Findings& findings_;
  Motion& motion_;
};

}  // namespace

void assembleRolling(const Draft& draft, const Body* body, Findings& findings, Motion& motion) {
  RollingAssembly(draft, body, findings, motion).run();
}

}  // namespace poinsot::scene
