// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/error.h"
#include "physics/inertia_tensor.h"
#include "scene/assembly/torque_table.h"
#include "scene/keys/shape_advice.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;

class ForcingAssembly {
 public:
  ForcingAssembly(const Draft& draft, const Body* body, Findings& findings, const SceneFolder& folder)
      : draft_(draft.forcing), body_(body), findings_(findings), folder_(folder) {}

  /// @param names  receives the labels of the forces
  physics::Forcing run(std::vector<std::string>& names) {
    forcing_.torque_B = draft_.torque_B.value_or(Vector3d::Zero());
    forcing_.torque_W = draft_.torque_W.value_or(Vector3d::Zero());
    forcing_.dragRate_P = draft_.dragRates.value_or(Vector3d::Zero());
    forcing_.dissipation = draft_.dissipation.value_or(0);
    emptyTables();
    gravity();
    torqueHistory();
    pointForces(names);
    return std::move(forcing_);
  }

 private:
  /// Rejects tables without keys. Such a table would change nothing, which nobody intends.
  void emptyTables() {
    refuseEmpty("motion.gravity", "mgr_body = [x, y, z], or g for a body with mass and pivot");
    refuseEmpty("motion.torque", "body = [x, y, z], space = [x, y, z], a file, or steps");
    refuseEmpty("motion.drag", "rate, one number or three");
    refuseEmpty("motion.dissipation", "alpha");
  }

  void refuseEmpty(const char* table, const char* keys) {
    if (findings_.hasTable(table) && !findings_.hasBelow(table))
      findings_.refuse(table, fmt::format("is empty; give {}", keys));
  }

  void gravity() {
    const bool mgr = findings_.has("motion.gravity.mgr_body"), g = findings_.has("motion.gravity.g");
    if (mgr && g)
      findings_.refuse("motion.gravity.g", "motion.gravity.mgr_body is given too; give one of the two");
    else if (mgr)
      givenMoment();
    else if (g)
      weight();
  }

  void givenMoment() {
    if (!draft_.mgr_B) return;
    forcing_.gravity_B = *draft_.mgr_B;
    if (!body_ || !body_->mass) return;
    if (!body_->pivot_B)
      findings_.refuse(
          "motion.gravity.mgr_body",
          "this body turns about its centre of mass, where its weight has no moment; give body.pivot and "
          "motion.gravity.g, or leave out body.mass if moments about the fixed point are given");
    else
      checkDirection(*draft_.mgr_B, lever_B());
  }

  /// Checks that the given vector M g r points from body.pivot to the centre of mass.
  void checkDirection(const Vector3d& mgr_B, const Vector3d& lever_B) {
    constexpr double kRounded = 1e-3;  // allowed sine of the angle, for values of three digits
    const double product = mgr_B.norm() * lever_B.norm();
    const bool along = mgr_B.cross(lever_B).norm() <= kRounded * product && mgr_B.dot(lever_B) > 0;
    if (mgr_B.isZero(0) || along) return;
    findings_.refuse(
        "motion.gravity.mgr_body",
        fmt::format("({:g}, {:g}, {:g}) N·m contradicts body.pivot: M g r must point from the pivot to the centre "
                    "of mass, along ({:g}, {:g}, {:g}) m; give motion.gravity.g instead",
                    mgr_B[0], mgr_B[1], mgr_B[2], lever_B[0], lever_B[1], lever_B[2]));
  }

  void weight() {
    if (!body_ || !draft_.g) return;
    if (!body_->mass)
      return findings_.refuse(
          "motion.gravity.g",
          fmt::format("{}, and body.pivot; or give motion.gravity.mgr_body instead", kNeedsMass));
    if (!body_->pivot_B)
      return findings_.refuse("motion.gravity.g",
                              "body.pivot is missing: about its centre of mass a body's weight has no moment (a "
                              "thrown body has [motion.flight] instead). For example, in [body]:\n    pivot = " +
                                  pivotText(findings_.leaves()));
    forcing_.gravity_B = body_->mass->mass_kg() * *draft_.g * lever_B();
  }

  Vector3d lever_B() const { return body_->mass->centre_B() - *body_->pivot_B; }

  void torqueHistory() {
    const bool file = findings_.has("motion.torque.file");
    const std::size_t steps = findings_.count("motion.torque.step");
    if (!file)
      for (const char* path : {"motion.torque.file_axes", "motion.torque.interpolation"})
        if (findings_.has(path))
          findings_.refuse(path, "has no effect without motion.torque.file; give the file, or leave this key out");
    if (file && steps > 0)
      findings_.refuse("motion.torque.step[0]",
                       "motion.torque.file is given too; give the torque by a file or by steps, not by both");
    else if (file)
      torqueFile();
    else if (steps > 0)
      torqueSteps(steps);
  }

  void torqueFile() {
    if (!draft_.torqueFile) return;
    try {
      auto& history = draft_.fileAxes == 1 ? forcing_.torqueHistory_W : forcing_.torqueHistory_B;
      history = readTorqueTable();
    } catch (const core::Error& error) {
      findings_.refuse("motion.torque.file", error.message());
    }
  }

  physics::TorqueHistory readTorqueTable() const {
    const std::string csv = folder_.read(*draft_.torqueFile);
    try {
      return parseTorqueTable(csv, draft_.interpolation == 0);
    } catch (const core::Error& error) {
      throw core::sceneError(fmt::format("{}: {}", *draft_.torqueFile, error.message()));
    }
  }

  void torqueSteps(std::size_t count) {
    bool good = true;
    for (std::size_t i = 0; i < count; ++i) good &= stepFits(i);
    if (!good) return;
    for (const TorqueStepDraft& step : draft_.steps) {
      add(forcing_.torqueHistory_B, *step.from, step.torque_B);
      add(forcing_.torqueHistory_W, *step.from, step.torque_W);
    }
  }

  static void add(physics::TorqueHistory& history, double t_s, const std::optional<Vector3d>& torque) {
    history.t_s.push_back(t_s);
    history.torque.push_back(torque.value_or(Vector3d::Zero()));
  }

  bool stepFits(std::size_t i) {
    const std::string table = fmt::format("motion.torque.step[{}]", i);
    const bool from = findings_.has(table + ".from");
    const bool torque = findings_.has(table + ".body") || findings_.has(table + ".space");
    if (!from || !torque) {
      const bool misspelt = findings_.misspelt(table + ".from") || findings_.misspelt(table + ".body") ||
                            findings_.misspelt(table + ".space");
      if (!misspelt)
        findings_.refuse(table, fmt::format("{} missing: a step has a time and a torque",
                                            from ? "body = [x, y, z] or space = [x, y, z] is" : "from is"));
      return false;
    }
    for (const char* name : {".from", ".body", ".space"})
      if (findings_.failed(table + name)) return false;
    return ascends(i, table + ".from");
  }

  bool ascends(std::size_t i, const std::string& path) {
    if (i == 0 || i >= draft_.steps.size() || !draft_.steps[i - 1].from) return true;
    const double before = *draft_.steps[i - 1].from, from = *draft_.steps[i].from;
    if (from > before) return true;
    findings_.refuse(path, fmt::format("must be later than the step before, got {} s after {} s", from, before));
    return false;
  }

  void pointForces(std::vector<std::string>& names) {
    const std::size_t count = findings_.count("motion.force");
    const bool flies = findings_.hasTable("motion.flight");
    if (count > 0 && flies && body_ && !body_->mass)
      findings_.refuse("motion.force[0]",
                       fmt::format("moves the centre of mass of a thrown body, so it {}", kNeedsMass));
    bool good = true;
    for (std::size_t i = 0; i < count; ++i) good &= forceFits(i);
    if (!good || !body_) return;
    for (const PointForceDraft& force : draft_.forces) {
      forcing_.forces.push_back({.lever_B = *force.at_B - body_->fixedPoint_B(),
                                 .force_B = force.force_B.value_or(Vector3d::Zero()),
                                 .force_W = force.force_W.value_or(Vector3d::Zero()),
                                 .from_s = force.from.value_or(-HUGE_VAL),
                                 .to_s = force.to.value_or(HUGE_VAL)});
      const std::string number = count > 1 ? fmt::format("_{{{}}}", forcing_.forces.size()) : "";
      names.push_back(force.name.value_or(fmt::format("$\\mathbf{{F}}{}$", number)));
    }
  }

  /// Checks that a force has its point, one vector and an end after its beginning.
  bool forceFits(std::size_t i) {
    const std::string table = fmt::format("motion.force[{}]", i);
    const bool body = findings_.has(table + ".body"), space = findings_.has(table + ".space");
    if (!findings_.has(table + ".at") || !(body || space)) {
      if (!isMisspelt(table, {".at", ".body", ".space"}))
        findings_.refuse(
            table, fmt::format("{} missing: a force has a point and a vector",
                               body || space ? "at = [x, y, z] is" : "body = [x, y, z] or space = [x, y, z] is"));
      return false;
    }
    if (body && space) {
      findings_.refuse(table + ".body", fmt::format("{}.space is given too; a force turns with the body or keeps "
                                                    "its direction in space; for both, give two forces",
                                                    table));
      return false;
    }
    for (const char* name : {".at", ".body", ".space", ".from", ".to", ".name"})
      if (findings_.failed(table + name)) return false;
    return endsLater(draft_.forces[i], table);
  }

  bool isMisspelt(const std::string& table, std::initializer_list<const char*> names) const {
    return std::ranges::any_of(names, [&](const char* name) { return findings_.misspelt(table + name); });
  }

  bool endsLater(const PointForceDraft& force, const std::string& table) {
    if (!force.from || !force.to || *force.from < *force.to) return true;
    findings_.refuse(table + ".to",
                     fmt::format("must be later than from, got {} s after {} s", *force.to, *force.from));
    return false;
  }

  const ForcingDraft& draft_;
  const Body* body_;
  Findings& findings_;
  const SceneFolder& folder_;
  physics::Forcing forcing_;
};

void checkThrownBy(Findings& findings) {
  if (!findings.has("motion.flight.velocity"))
    findings.refuseMissing(
        "motion.flight.velocity", "motion.flight.point",
        "needs motion.flight.velocity, the velocity of this point; to throw the body by its centre "
        "of mass, leave out point");
  if (massIsUnknown(findings)) findings.refuse("motion.flight.point", kNeedsMass);
}

}  // namespace

void assembleForcing(const Draft& draft, const Body* body, Findings& findings, const SceneFolder& folder,
                     Motion& motion) {
  motion.forcing = ForcingAssembly(draft, body, findings, folder).run(motion.forceNames);
}

void throwByPoint(const Draft& draft, Scene& scene) {
  Motion& motion = scene.motion;
  if (!motion.flight || !draft.flight.point || !scene.body.mass) return;
  motion.thrownBy_B = draft.flight.point;
  if (!motion.orientation_WB) motion.orientation_WB = physics::Quaternion::Identity();
  const auto inW = [&](const Eigen::Vector3d& v_B) { return physics::turnedVector(*motion.orientation_WB, v_B); };
  const Eigen::Vector3d c_W = inW(scene.body.mass->centre_B() - *motion.thrownBy_B);
  motion.flight->position_W += c_W;
  motion.flight->velocity_W += inW(motion.omega_B).cross(c_W);
}

std::optional<Flight> assembleFlight(const Draft& draft, Findings& findings) {
  if (!findings.hasTable("motion.flight")) return std::nullopt;
  for (const char* held : {"body.pivot", "motion.gravity"})
    if (findings.has(held) || findings.hasTable(held))
      findings.refuse("motion.flight", fmt::format("a thrown body turns about its centre of mass, but {} holds it "
                                                   "at a fixed point; leave out one of the two",
                                                   held));
  if (findings.has("motion.flight.point")) checkThrownBy(findings);
  Flight flight;
  flight.position_W = draft.flight.position.value_or(flight.position_W);
  flight.velocity_W = draft.flight.velocity.value_or(flight.velocity_W);
  flight.gravity_W = draft.flight.gravity.value_or(flight.gravity_W);
  return flight;
}

}  // namespace poinsot::scene
