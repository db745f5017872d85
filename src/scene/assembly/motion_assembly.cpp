// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "physics/level_attitude.h"
#include "physics/start.h"
#include "scene/limits.h"
#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using physics::Quaternion;

/// One of the ways to give a start of the motion, as a list of keys. The first `required` keys must be given.
struct Way {
  std::vector<std::string_view> names;
  std::size_t required;
};

const std::vector<Way>& ways() {
  static const std::vector<Way> all = {{{"omega_body"}, 1},
                                       {{"omega_space"}, 1},
                                       {{"L_body"}, 1},
                                       {{"L_space"}, 1},
                                       {{"spin", "spin_axis", "tilt", "tilt_towards"}, 2},
                                       {{"energy", "L", "phase", "branch"}, 2}};
  return all;
}

std::string pathOf(std::string_view name) { return fmt::format("motion.{}", name); }

/// Returns whether gravity or a torque can set a body in motion that is at rest.
bool setsGoing(const physics::Forcing& forcing) {
  physics::Forcing torques = forcing;
  torques.dragRate_P.setZero();
  torques.dissipation = 0;
  return !torques.none();
}

/// Returns a vector as TOML for a message, such as "[0.5, 0, -1]". Rounds components below 1e-12 to 0.
template <class Vector>
std::string pasted(const Vector& values) {
  std::string text;
  for (const double value : values)
    text += fmt::format("{}{:.12g}", text.empty() ? "[" : ", ", std::abs(value) < 1e-12 ? 0 : value);
  return text + "]";
}

class StartAssembly {
 public:
  StartAssembly(const Draft& draft, const Body* body, Findings& findings, Motion& motion)
      : start_(draft.start), mgr_B_(draft.forcing.mgr_B), body_(body), findings_(findings), motion_(motion) {}

  std::optional<Rest> run() {
    std::vector<const Way*> given;
    for (const Way& way : ways())
      if (!firstGiven(way).empty()) given.push_back(&way);
    if (given.empty())
      refuseNone();
    else if (given.size() > 1)
      refuseSecond(*given[0], *given[1]);
    else if (complete(*given[0]))
      start(firstGiven(*given[0]));
    return std::move(rest_);
  }

 private:
  std::string firstGiven(const Way& way) const {
    for (const std::string_view name : way.names)
      if (findings_.has(pathOf(name))) return pathOf(name);
    return "";
  }

  void refuseNone() {
    if (findings_.misspelt("motion")) return;
    for (const Way& way : ways())
      for (const std::string_view name : way.names)
        if (findings_.misspelt(pathOf(name))) return;
    findings_.refuse("motion.omega_body",
                     "a start is required: give the angular velocity, such as [0.01, 3.0, 0.0]");
  }

  void refuseSecond(const Way& first, const Way& second) {
    findings_.refuse(firstGiven(second),
                     fmt::format("{} is given too; a start is given in one way: omega_body, omega_space, L_body, "
                                 "L_space, spin and spin_axis, or energy and L",
                                 firstGiven(first)));
  }

  bool complete(const Way& way) {
    for (std::size_t i = 0; i < way.required; ++i) {
      if (findings_.has(pathOf(way.names[i]))) continue;
      const std::vector<std::string_view> needed(way.names.begin(),
                                                 way.names.begin() + static_cast<std::ptrdiff_t>(way.required));
      findings_.refuseMissing(
          pathOf(way.names[i]), firstGiven(way),
          fmt::format("{} is missing: give {} together", pathOf(way.names[i]), listed(needed)));
      return false;
    }
    return true;
  }

  void start(const std::string& path) {
    chooseOrientation();
    checkTilt();
    if (const auto value = restText()) return atRest({path, *value});
    motion_.omega_B = Vector3d::Ones();  // nonzero, so that a rejected start is not taken for rest
    if (!body_) return;
    try {
      if (const auto omega_B = omega()) setOmega(*omega_B, path);
    } catch (const core::Error& error) {
      findings_.refuse(path, error.message());
    }
  }

  void chooseOrientation() {
    const bool inSpace = findings_.has("motion.omega_space") || findings_.has("motion.L_space");
    const bool turned = setsGoing(motion_.forcing) || !motion_.forcing.dragRate_P.isZero(0);
    if ((inSpace || turned) && !findings_.has("motion.orientation"))
      motion_.orientation_WB = Quaternion::Identity();
  }

  void checkTilt() {
    if (findings_.has("motion.tilt_towards") && !findings_.has("motion.tilt"))
      findings_.refuseMissing("motion.tilt", "motion.tilt_towards",
                              "motion.tilt is missing: a direction of tilt needs an angle; give both or neither");
    if (start_.tilt.value_or(0) == 0) return;
    if (gravityPulls())
      findings_.refuse("motion.tilt", underGravity());
    else if (start_.spin == 0.0 && (setsGoing(motion_.forcing) || findings_.has("motion.orientation")))
      findings_.refuse("motion.tilt",
                       "has no effect if motion.spin is 0, because L is 0; leave it out, or give a spin");
  }

  /// Returns whether the scene has gravity. Also true if [motion.gravity] contains a mistake, so that one run
  /// reports this mistake and the one in the tilt.
  bool gravityPulls() const {
    return !motion_.forcing.gravity_B.isZero(0) || (findings_.hasBelow("motion.gravity") && !mgr_B_);
  }

  std::string underGravity() const {
    std::vector<std::string_view> names{"tilt"};
    if (findings_.has("motion.tilt_towards")) names.emplace_back("tilt_towards");
    const bool computable =
        body_ && start_.spin && findings_.has("motion.spin_axis") && passed({"spin_axis", "tilt_towards"});
    if (findings_.has("motion.orientation"))
      return "cannot tilt a body under gravity, because motion.orientation sets its attitude; leave out " +
             listed(names) + (computable ? sameNutation(names) : "");
    return fmt::format(
        "cannot tilt a body under gravity, whose axes are the world's at the start; give motion.orientation{} "
        "instead of {}",
        computable ? orientationLeaning() : "", listed(names));
  }

  std::string sameNutation(std::vector<std::string_view> names) const {
    names.insert(names.begin(), {"spin", "spin_axis"});
    return fmt::format("; for the same nutation give motion.omega_body = {} instead of {}",
                       pasted(omegaTilted(*start_.spin)), listed(names));
  }

  std::string orientationLeaning() const {
    return fmt::format(" = {}, which tilts spin_axis by {:g} deg from the vertical,", pasted(leaning()),
                       *start_.tilt * 180 / std::numbers::pi);
  }

  Vector3d omegaTilted(double spin) const {
    return physics::omegaFromSpin(body_->axes,
                                  {spinAxis(), spin, start_.tilt.value_or(0), start_.tiltTowards.value_or(0)});
  }

  /// Returns the attitude, as w, x, y, z, in which L points up. Without gravity, spin_axis then leans from the
  /// vertical by the angle `tilt`.
  Eigen::Vector4d leaning() const {
    const Vector3d up_B = body_->axes.angularMomentum(omegaTilted(1));
    const Quaternion q_WB = physics::turnOntoVertical(up_B, physics::Vertical::kUp);
    return {q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z()};
  }

  /// Returns the rotation that the scene gives, such as "0 rad/s", if it is zero; otherwise nullopt.
  std::optional<std::string> restText() const {
    const auto isZero = [](const std::optional<Vector3d>& v) { return v && v->isZero(0); };
    if (isZero(start_.omega_B) || isZero(start_.omega_W)) return "(0, 0, 0) rad/s";
    if (isZero(start_.L_B) || isZero(start_.L_W)) return "(0, 0, 0) kg·m²/s";
    if (start_.spin == 0.0) return "0 rad/s";
    return std::nullopt;
  }

  void atRest(Rest rest) {
    motion_.omega_B = Vector3d::Zero();
    if (setsGoing(motion_.forcing)) return;
    if (motion_.orientation_WB || findings_.has("motion.orientation"))
      rest_ = std::move(rest);
    else
      findings_.refuse(rest.path,
                       fmt::format("must not be zero, got {}: without rotation L has no direction to turn "
                                   "onto the vertical; give a rotation, or motion.orientation",
                                   rest.value));
  }

  std::optional<Vector3d> omega() const {
    const physics::PrincipalAxes& axes = body_->axes;
    const Quaternion q_WB = motion_.orientation_WB.value_or(Quaternion::Identity());
    if (start_.omega_B) return start_.omega_B;
    if (start_.omega_W) return physics::omegaFromSpace(q_WB, *start_.omega_W);
    if (start_.L_B) return axes.angularVelocity(*start_.L_B);
    if (start_.L_W) return physics::omegaFromMomentum(axes, q_WB, *start_.L_W);
    if (start_.spin && passed({"spin_axis", "tilt", "tilt_towards"})) return omegaTilted(*start_.spin);
    if (start_.energy && start_.L && passed({"phase", "branch"}))
      return physics::omegaFromEnergy(axes,
                                      {*start_.energy, *start_.L, start_.phase.value_or(0), start_.branch == 1});
    return std::nullopt;
  }

  /// Returns whether none of the keys failed its own check. A missing key counts as passed.
  bool passed(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names)
      if (findings_.failed(pathOf(name))) return false;
    return true;
  }

  int spinAxis() const {
    if (start_.spinAxis < 3) return start_.spinAxis;
    return body_->axes.moments().ascendingAxes()[static_cast<std::size_t>(start_.spinAxis - 3)];
  }

  void setOmega(const Vector3d& omega_B, const std::string& path) {
    const double largest = omega_B.cwiseAbs().maxCoeff();
    if (!(largest >= kLeastSpin && largest <= kMostSpin))
      return findings_.refuse(path,
                              fmt::format("with these moments the angular velocity is ({}, {}, {}) rad/s; its "
                                          "largest component must be from {:g} to {:g} rad/s",
                                          omega_B[0], omega_B[1], omega_B[2], kLeastSpin, kMostSpin));
    motion_.omega_B = omega_B;
  }

  const StartDraft& start_;
  const std::optional<Vector3d>& mgr_B_;
  const Body* body_;
  Findings& findings_;
  Motion& motion_;
  std::optional<Rest> rest_;
};

}  // namespace

std::optional<Rest> assembleStart(const Draft& draft, const Body* body, Findings& findings, Motion& motion) {
  return StartAssembly(draft, body, findings, motion).run();
}

}  // namespace poinsot::scene
