// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"
#include "physics/euler_angles.h"
#include "physics/mean_periods.h"
#include "physics/start.h"
#include "scene/assembly/top_start.h"
#include "scene/keys/shape_advice.h"
#include "scene/keys/start_ways.h"
#include "scene/limits.h"
#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using physics::Quaternion;

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
    for (const StartWay& way : startWays())
      if (!firstGiven(way).empty()) given_.push_back(&way);
    if (contradicts()) return std::move(rest_);
    checkTilt();
    if (complete()) start();
    return std::move(rest_);
  }

 private:
  /// Returns the path of the first key of a way that the scene gives; empty if it gives none.
  std::string firstGiven(const StartWay& way) const {
    const bool isRate = start_.precession.has_value();  // the key gives a rate, or the words slow and fast
    if (way.name == "a rate of precession" && !isRate) return "";
    if (way.name == "precession slow or fast" && isRate) return "";
    for (const std::string_view name : way.keys)
      if (given(name) && (given(way.keys[0]) || &way == ownerOf(name))) return tableOrKey(name);
    return "";
  }

  /// Returns the path of a key, or of a table, whose name ends in a point.
  static std::string tableOrKey(std::string_view name) {
    return pathOf(name.ends_with('.') ? name.substr(0, name.size() - 1) : name);
  }

  bool given(std::string_view name) const {
    return name.ends_with('.') ? findings_.hasBelow(tableOrKey(name)) : findings_.has(pathOf(name));
  }

  /// Returns the way for which a key counts: of the ways with this key, one whose first key the scene gives, or
  /// else the first.
  const StartWay* ownerOf(std::string_view name) const {
    const StartWay* owner = nullptr;
    for (const StartWay& way : startWays()) {
      if (std::ranges::find(way.keys, name) == way.keys.end()) continue;
      if (given(way.keys[0])) return &way;
      if (!owner) owner = &way;
    }
    return owner;
  }

  bool contradicts() {
    for (std::size_t second = 1; second < given_.size(); ++second)
      for (std::size_t first = 0; first < second; ++first)
        if (!combine(*given_[first], *given_[second])) {
          refuseSecond(*given_[first], *given_[second]);
          return true;
        }
    return false;
  }

  void refuseSecond(const StartWay& first, const StartWay& second) {
    findings_.refuse(firstGiven(second),
                     fmt::format("{} is given too; {}", firstGiven(first), rule(first, second)));
  }

  static std::string rule(const StartWay& first, const StartWay& second) {
    const auto gives = [&](StartPart part) { return first.part == part && second.part == part; };
    if (gives(StartPart::kAttitude)) return "an attitude is given in one way: " + namesOf(StartPart::kAttitude);
    if (gives(StartPart::kRotation)) return "a rotation is given in one way: " + namesOf(StartPart::kRotation);
    if (first.name == "euler_rates") return "rates of Euler angles need motion.euler, or no attitude";
    if (first.part == StartPart::kRotation) return fmt::format("{} needs spin and spin_axis", second.name);
    return "a top starts in one way: tilt, precession or nutation";
  }

  static std::string namesOf(StartPart part) {
    std::vector<std::string_view> names;
    for (const StartWay& way : startWays())
      if (way.part == part) names.push_back(way.name);
    const std::string last(names.back());
    names.pop_back();
    return core::joined(names, ", ") + " or " + last;
  }

  /// Returns whether an unknown name of the scene stands for a start.
  bool startIsMisspelt() const {
    if (findings_.misspelt("motion")) return true;
    for (const StartWay& way : startWays())
      for (const std::string_view name : way.keys)
        if (name.ends_with('.') ? findings_.isMeantBelow(tableOrKey(name)) : findings_.misspelt(pathOf(name)))
          return true;
    return false;
  }

  bool complete() {
    for (const StartWay* way : given_)
      for (std::size_t i = 0; i < way->required; ++i)
        if (!findings_.has(pathOf(way->keys[i])) && way->required > 1) {
          if (!findings_.failed(firstGiven(*way)) || !startIsMisspelt())
            refuseIncomplete(*way, *way, way->keys[i]);
          return false;
        }
    for (const StartWay* way : given_)
      if (way->part == StartPart::kRotation) return true;
    refuseNoRotation();
    return false;
  }

  /// @param given  way of which the scene has a key
  /// @param needed  way of which it lacks the key `missing`
  void refuseIncomplete(const StartWay& given, const StartWay& needed, std::string_view missing) {
    const std::vector<std::string_view> together(
        needed.keys.begin(), needed.keys.begin() + static_cast<std::ptrdiff_t>(needed.required));
    findings_.refuseMissing(pathOf(missing), firstGiven(given),
                            fmt::format("{} is missing: give {} together. For example:\n    {} = {}",
                                        pathOf(missing), listed(together), missing, exampleOf(missing)));
  }

  std::string exampleOf(std::string_view name) const {
    return name == "spin_axis" ? spinAxisText(findings_.leaves()) : std::string(findKey(pathOf(name))->example);
  }

  void refuseNoRotation() {
    for (const StartWay* way : given_)
      if (way->part == StartPart::kTilt || way->part == StartPart::kTop)
        return refuseIncomplete(*way, startWay("spin and spin_axis"), "spin");
    if (!startIsMisspelt())
      findings_.refuse("motion.omega_body",
                       "a start is required: give the angular velocity. For example, in [motion]:\n    omega_body "
                       "= [0.01, 3.0, 0.0]");
  }

  void start() {
    chooseOrientation();
    const std::string path = pathOfRotation();
    if (const auto value = restText()) return atRest({path, *value});
    motion_.omega_B = Vector3d::Ones();  // nonzero, so that a rejected start is not taken for rest
    if (!body_) return;
    try {
      if (const auto omega_B = omega()) setOmega(*omega_B, path);
    } catch (const core::Error& error) {
      findings_.refuse(path, error.message());
    }
  }

  std::string pathOfRotation() const {
    for (const StartWay* way : given_)
      if (way->part == StartPart::kRotation) return firstGiven(*way);
    return "motion";
  }

  bool gives(StartPart part) const {
    return std::ranges::any_of(given_, [part](const StartWay* way) { return way->part == part; });
  }

  void chooseOrientation() {
    if (findings_.hasBelow("motion.euler") && passed({"euler.precession", "euler.nutation", "euler.spin"}))
      motion_.orientation_WB = physics::attitudeOf(start_.euler);
    else if (start_.rollPitchYaw)
      motion_.orientation_WB = physics::attitudeOf(
          physics::RollPitchYaw{(*start_.rollPitchYaw)[0], (*start_.rollPitchYaw)[1], (*start_.rollPitchYaw)[2]});
    else if (start_.lean)
      lean();
    const bool inSpace = findings_.has("motion.omega_space") || findings_.has("motion.L_space");
    const bool turned = setsGoing(motion_.forcing) || !motion_.forcing.dragRate_P.isZero(0);
    if ((inSpace || turned || findings_.hasBelow("motion.euler_rates")) && !gives(StartPart::kAttitude))
      motion_.orientation_WB = Quaternion::Identity();
  }

  void lean() {
    motion_.orientation_WB = Quaternion::Identity();  // in case there is no axis
    const auto axis_B = axisOfLean();
    if (axis_B) motion_.orientation_WB = physics::leaningAttitude(*axis_B, *start_.lean);
  }

  std::optional<Vector3d> axisOfLean() {
    if (!body_ || findings_.failed("motion.spin_axis")) return std::nullopt;
    if (const auto axis_B = spinAxis_B()) return axis_B;
    if (!motion_.forcing.gravity_B.isZero(0)) return motion_.forcing.gravity_B.stableNormalized();
    if (!gravityPulls())
      findings_.refuseMissing(
          "motion.spin_axis", "motion.lean",
          "motion.spin_axis is missing: it names the axis that leans; without gravity, no axis "
          "is marked. For example:\n    spin_axis = " +
              exampleOf("spin_axis"));
    return std::nullopt;
  }

  void checkTilt() {
    if (findings_.has("motion.tilt_towards") && !findings_.has("motion.tilt"))
      findings_.refuseMissing("motion.tilt", "motion.tilt_towards",
                              "motion.tilt is missing: a direction of tilt needs an angle; give both or neither");
    if (start_.tilt.value_or(0) == 0) return;
    if (gravityPulls())
      findings_.refuse("motion.tilt", underGravity());
    else if (start_.spin == 0.0 && (setsGoing(motion_.forcing) || gives(StartPart::kAttitude)))
      findings_.refuse("motion.tilt",
                       "has no effect if motion.spin is 0, because L is 0; leave it out, or give a spin");
  }

  /// Returns whether the scene has gravity. Also true if [motion.gravity] contains a mistake, so that one run
  /// reports this mistake and the one in the tilt.
  bool gravityPulls() const {
    return !motion_.forcing.gravity_B.isZero(0) || findings_.isMeantBelow("motion.gravity") ||
           (findings_.hasBelow("motion.gravity") && !mgr_B_);
  }

  std::string underGravity() const {
    std::vector<std::string_view> names{"tilt"};
    if (findings_.has("motion.tilt_towards")) names.emplace_back("tilt_towards");
    if (!gives(StartPart::kAttitude)) {
      const std::string tilt = findings_.textOf("motion.tilt");
      return fmt::format(
          "cannot tilt L under gravity, whose vertical is fixed; to lean the body, give motion.lean instead of "
          "{0}{1}. For example, in place of {0}:\n    lean = {2}",
          listed(names), tilt.starts_with('"') ? "" : " (a bare angle is in radians)", tilt);
    }
    const bool computable =
        body_ && start_.spin && findings_.has("motion.spin_axis") && passed({"spin_axis", "tilt_towards"});
    return "cannot tilt L under gravity, because the scene gives the attitude; leave out " + listed(names) +
           (computable ? sameNutation(names) : "");
  }

  std::string sameNutation(std::vector<std::string_view> names) const {
    names.insert(names.begin(), {"spin", "spin_axis"});
    return fmt::format("; for the same nutation give motion.omega_body = {} instead of {}",
                       pasted(omegaTilted(*start_.spin)), listed(names));
  }

  Vector3d omegaTilted(double spin) const {
    return physics::omegaFromSpin(body_->axes,
                                  {spinAxis(), spin, start_.tilt.value_or(0), start_.tiltTowards.value_or(0)});
  }

  /// Returns the rotation that the scene gives, such as "0 rad/s", if it is zero; otherwise nullopt.
  std::optional<std::string> restText() const {
    const auto isZero = [](const std::optional<Vector3d>& v) { return v && v->isZero(0); };
    if (isZero(start_.omega_B) || isZero(start_.omega_W)) return "(0, 0, 0) rad/s";
    if (isZero(start_.L_B) || isZero(start_.L_W)) return "(0, 0, 0) kg·m²/s";
    const auto& [phi, theta, psi] = start_.eulerRates;
    if (findings_.hasBelow("motion.euler_rates") && phi == 0 && theta == 0 && psi == 0) return "0 rad/s";
    if (start_.spin == 0.0 && !isTopStart(start_)) return "0 rad/s";
    return std::nullopt;
  }

  void atRest(Rest rest) {
    motion_.omega_B = Vector3d::Zero();
    if (setsGoing(motion_.forcing)) return;
    if (motion_.orientation_WB || gives(StartPart::kAttitude))
      rest_ = std::move(rest);
    else
      findings_.refuse(rest.path,
                       fmt::format("must not be zero, got {}: without rotation L has no direction to turn "
                                   "onto the vertical; give a rotation, or motion.orientation",
                                   rest.value));
  }

  std::optional<Vector3d> omega() {
    const physics::PrincipalAxes& axes = body_->axes;
    const Quaternion q_WB = motion_.orientation_WB.value_or(Quaternion::Identity());
    if (start_.omega_B) return start_.omega_B;
    if (isTopStart(start_)) return omegaOfTop();
    if (findings_.hasBelow("motion.euler_rates")) return omegaOfEulerRates();
    if (start_.omega_W) return physics::omegaFromSpace(q_WB, *start_.omega_W);
    if (start_.L_B) return axes.angularVelocity(*start_.L_B);
    if (start_.L_W) return physics::omegaFromMomentum(axes, q_WB, *start_.L_W);
    if (start_.spin && passed({"spin_axis", "tilt", "tilt_towards"})) return omegaTilted(*start_.spin);
    if (start_.periodPhi && start_.periodPsi && passed({"mode", "phase", "branch"}))
      return physics::omegaFromPeriods(
          axes, {*start_.periodPhi, *start_.periodPsi, start_.mode, start_.phase.value_or(0), start_.branch == 1});
    if (start_.energy && start_.L && passed({"phase", "branch"}))
      return physics::omegaFromEnergy(axes,
                                      {*start_.energy, *start_.L, start_.phase.value_or(0), start_.branch == 1});
    return std::nullopt;
  }

  std::optional<Vector3d> omegaOfTop() {
    if (gravityPulls() && motion_.forcing.gravity_B.isZero(0)) return std::nullopt;  // reported already
    if (!motion_.orientation_WB || !passed({"spin", "spin_axis", "lean", "orientation"})) return std::nullopt;
    return topOmega(start_, *body_, motion_, spinAxis_B(), findings_);
  }

  std::optional<Vector3d> omegaOfEulerRates() const {
    const bool valid = passed({"euler.precession", "euler.nutation", "euler.spin", "euler_rates.precession",
                               "euler_rates.nutation", "euler_rates.spin"});
    return valid ? std::optional(physics::omegaFromEulerRates(start_.euler, start_.eulerRates)) : std::nullopt;
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

  /// Returns the unit vector of spin_axis; nullopt if the scene does not give it, or the body is invalid.
  std::optional<Vector3d> spinAxis_B() const {
    if (!body_ || !findings_.has("motion.spin_axis")) return std::nullopt;
    return body_->axes.toB(Vector3d::Unit(spinAxis()));
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
  std::vector<const StartWay*> given_;  ///< in the order of startWays()
  std::optional<Rest> rest_;
};

}  // namespace

std::optional<Rest> assembleStart(const Draft& draft, const Body* body, Findings& findings, Motion& motion) {
  return StartAssembly(draft, body, findings, motion).run();
}

}  // namespace poinsot::scene
