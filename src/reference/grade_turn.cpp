// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_turn.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "reference/grade_turn_words.h"

namespace poinsot::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using physics::Quaternion;

constexpr double kTurned_rad = 0.001;  // smaller angles count as rounding, not as other axes

const double kExchangeAllowance = std::log(20.);  // largest excess of the score if axes are exchanged

/// Rotations from components along the log's axes to components along the scene's axes, for body and space.
struct Turn {
  Quaternion body = Quaternion::Identity(), space = Quaternion::Identity();
};

enum class Columns { kAll, kAttitude, kOmega };

LoggedState turned(LoggedState s, const Turn& turn, Columns columns) {
  const auto apply = [](std::optional<Vector3d>& v, const Quaternion& q) {
    if (v) v = q * *v;
  };
  if (s.q_WB && columns != Columns::kOmega) s.q_WB = turn.space * *s.q_WB * turn.body.conjugate();
  if (columns == Columns::kAttitude) return s;
  apply(s.omega_B, turn.body);
  apply(s.rate_B, turn.body);
  apply(s.omega_W, turn.space);
  apply(s.rate_W, turn.space);
  if (columns == Columns::kAll) apply(s.L_W, turn.space);
  return s;
}

/// Returns the rotations that map coordinate axes to coordinate axes, except the identity. Half turns come first.
std::vector<Quaternion> makeExchanges() {
  std::vector<Quaternion> turns;
  std::array<int, 3> axes{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Matrix3d m = Matrix3d::Zero();
      for (int i = 0; i < 3; ++i) m(i, axes[static_cast<std::size_t>(i)]) = (signs >> i & 1) != 0 ? -1 : 1;
      if (m.determinant() > 0 && !m.isIdentity()) turns.emplace_back(m);
    }
  } while (std::ranges::next_permutation(axes).found);
  std::ranges::stable_sort(turns, std::ranges::greater(),
                           [](const Quaternion& q) { return std::round(1e3 * angleOf(q)); });
  return turns;
}

const std::vector<Quaternion>& exchanges() {
  static const std::vector<Quaternion> turns = makeExchanges();
  return turns;
}

/// Least-squares fit of a rotation that maps vectors or attitudes of the log to those of the motion. Both kinds of
/// fit maximise a quadratic form in the unit quaternion of the rotation, so the signs of quaternions have no
/// effect (P. Davenport's q-method; F. L. Markley et al., J. Guid. Control Dyn. 30 (2007) 1193).
class TurnFit {
 public:
  void add(const Vector3d& ours, const Vector3d& theirs) {
    const Matrix3d product = ours * theirs.transpose();
    const Vector3d axial = theirs.cross(ours);
    form_.topLeftCorner<3, 3>() += product + product.transpose() - ours.dot(theirs) * Matrix3d::Identity();
    form_.topRightCorner<3, 1>() += axial;
    form_.bottomLeftCorner<1, 3>() += axial.transpose();
    form_(3, 3) += ours.dot(theirs);
  }
  void add(const Quaternion& turn) { form_ += turn.coeffs() * turn.coeffs().transpose(); }

  /// Returns the rotation that fits best. If several fit equally well, for example for parallel vectors, returns
  /// the one with the smallest angle.
  Quaternion turn() const {
    constexpr double kEqual = 1e-14;
    const Eigen::SelfAdjointEigenSolver<Matrix4d> solver(form_);
    const Vector4d& values = solver.eigenvalues();  // in ascending order
    const double least = values[3] - kEqual * values.cwiseAbs().maxCoeff();
    Vector4d best = solver.eigenvectors().col(3), smallest = Vector4d::Zero();
    for (int i = 0; i < 4; ++i)
      if (values[i] >= least) smallest += solver.eigenvectors()(3, i) * solver.eigenvectors().col(i);
    if (values[2] >= least && !smallest.isZero(kEqual)) best = smallest.normalized();
    return Quaternion(best);
  }

 private:
  Matrix4d form_ = Matrix4d::Zero();  ///< rows and columns in the order x, y, z, w
};

/// Returns the axis of a rotation times the sine of its angle. This vector rotates with the axes.
Vector3d axialOf(const Quaternion& q) { return 2 * q.w() * q.vec(); }

template <class Add>
TurnFit fitOver(const LogSample& sample, const Add& add) {
  TurnFit fit;
  for (std::size_t i = 0; i < sample.theirs.size(); ++i) add(fit, sample.ours[i], sample.theirs[i]);
  return fit;
}

/// Returns the largest |omega| of a sample, by which omega is divided to give it the weight of a rotation; never
/// 0.
double scaleOf(const LogSample& sample) {
  const double largest = largestOmega(sample);
  return largest > 0 ? largest : 1;
}

/// Fits a rotation of the body's axes to omega_B and to the change of the attitude since the first row.
Quaternion fittedBody(const LogSample& sample) {
  const double scale = scaleOf(sample);
  const Quaternion ours0 = sample.ours.front().q_WB.conjugate();
  const Quaternion theirs0 = sample.theirs.front().q_WB->conjugate();
  return fitOver(sample,
                 [&](TurnFit& fit, const physics::RigidBodyState& ours, const LoggedState& theirs) {
                   if (theirs.omega_B) fit.add(ours.omega_B / scale, *theirs.omega_B / scale);
                   fit.add(axialOf(ours0 * ours.q_WB), axialOf(theirs0 * *theirs.q_WB));
                 })
      .turn();
}

Quaternion fittedCommon(const LogSample& sample) {
  const double scale = scaleOf(sample);
  return fitOver(sample,
                 [&](TurnFit& fit, const physics::RigidBodyState& ours, const LoggedState& theirs) {
                   if (theirs.omega_B) fit.add(ours.omega_B / scale, *theirs.omega_B / scale);
                   if (theirs.omega_W) fit.add(ours.omega_W / scale, *theirs.omega_W / scale);
                   fit.add(axialOf(ours.q_WB), axialOf(*theirs.q_WB));
                 })
      .turn();
}

Quaternion fittedBodyAlone(const LogSample& sample) {
  return fitOver(sample, [](TurnFit& fit, const physics::RigidBodyState& ours,
                            const LoggedState& theirs) { fit.add(ours.q_WB.conjugate() * *theirs.q_WB); })
      .turn();
}

Quaternion fittedSpaceAlone(const LogSample& sample) {
  return fitOver(sample, [](TurnFit& fit, const physics::RigidBodyState& ours,
                            const LoggedState& theirs) { fit.add(ours.q_WB * theirs.q_WB->conjugate()); })
      .turn();
}

Quaternion fittedOmega(const LogSample& sample) {
  return fitOver(sample,
                 [](TurnFit& fit, const physics::RigidBodyState& ours, const LoggedState& theirs) {
                   if (theirs.omega_B)
                     fit.add(ours.omega_B, *theirs.omega_B);
                   else
                     fit.add(ours.omega_W, *theirs.omega_W);
                 })
      .turn();
}

LogSample turned(LogSample sample, const Turn& turn, Columns columns) {
  for (LoggedState& theirs : sample.theirs) theirs = turned(std::move(theirs), turn, columns);
  return sample;
}

/// Returns an exchange of axes if one fits about as well as `fitted`. Otherwise returns `fitted`.
Quaternion chosenTurn(const Quaternion& fitted, const std::function<double(const Quaternion&)>& score) {
  const auto best = std::ranges::min_element(exchanges(), {}, score);
  return score(*best) <= score(fitted) + kExchangeAllowance ? *best : fitted;
}

struct TurnKind {
  bool (*applies)(const LoggedState&);
  Quaternion (*fit)(const LogSample&);
  Turn (*turn)(const Quaternion&);
  Columns columns;
  TurnedAxes axes;
};

Reading turnReading(TurnedAxes axes, const Quaternion& q, const Turn& turn, Columns columns) {
  return {Aspect::kAxes, turnCause(axes, q),
          [turn, columns](LoggedState s) { return turned(std::move(s), turn, columns); }};
}

std::optional<Reading> readingOf(const TurnKind& kind, const LogSample& sample) {
  if (!kind.applies(sample.theirs.front())) return std::nullopt;
  const Quaternion q = chosenTurn(kind.fit(sample), [&](const Quaternion& candidate) {
    return scoreOf(turned(sample, kind.turn(candidate), kind.columns));
  });
  if (!(angleOf(q) > kTurned_rad)) return std::nullopt;
  return turnReading(kind.axes, q, kind.turn(q), kind.columns);
}

bool hasBoth(const LoggedState& s) { return s.q_WB && (s.omega_B || s.omega_W); }
bool hasOneOmega(const LoggedState& s) { return s.omega_B.has_value() != s.omega_W.has_value(); }

Turn both(const Quaternion& q) { return {q, q}; }
Turn body(const Quaternion& q) { return {q, Quaternion::Identity()}; }
Turn space(const Quaternion& q) { return {Quaternion::Identity(), q}; }

/// Returns the rotation of the space axes that fits best if the body's axes are rotated by `bodyTurn`.
Quaternion spaceBeside(const LogSample& sample, const Quaternion& bodyTurn) {
  const LogSample half = turned(sample, body(bodyTurn), Columns::kAll);
  return chosenTurn(fittedSpaceAlone(half), [&](const Quaternion& candidate) {
    return scoreOf(turned(half, space(candidate), Columns::kAll));
  });
}

std::optional<Reading> twoTurns(const LogSample& sample) {
  if (!hasAttitude(sample.theirs.front())) return std::nullopt;
  const Quaternion bodyTurn = chosenTurn(fittedBody(sample), [&](const Quaternion& candidate) {
    const LogSample half = turned(sample, body(candidate), Columns::kAll);
    return scoreOf(turned(half, space(fittedSpaceAlone(half)), Columns::kAll));
  });
  const Turn turn{bodyTurn, spaceBeside(sample, bodyTurn)};
  const FitCause ofBody = turnCause(TurnedAxes::kBody, turn.body),
                 ofSpace = turnCause(TurnedAxes::kSpace, turn.space);
  const FitCause cause{fmt::format("{} ({}) and {}", ofBody.condition, ofBody.remark, ofSpace.condition),
                       ofSpace.remark};
  return Reading{Aspect::kAxes, cause,
                 [turn](LoggedState s) { return turned(std::move(s), turn, Columns::kAll); }};
}

}  // namespace

std::vector<Hypothesis> turnHypotheses() {
  const TurnKind kinds[] = {
      {hasAttitude, fittedCommon, both, Columns::kAll, TurnedAxes::kBoth},
      {hasAttitude, fittedBodyAlone, body, Columns::kAll, TurnedAxes::kBody},
      {hasAttitude, fittedSpaceAlone, space, Columns::kAll, TurnedAxes::kSpace},
      {hasBoth, fittedBodyAlone, body, Columns::kAttitude, TurnedAxes::kBodyOfAttitude},
      {hasBoth, fittedSpaceAlone, space, Columns::kAttitude, TurnedAxes::kSpaceOfAttitude},
      {hasOneOmega, fittedOmega, both, Columns::kOmega, TurnedAxes::kOmega},
  };
  std::vector<Hypothesis> hypotheses;
  for (const TurnKind& kind : kinds)
    hypotheses.push_back({Aspect::kAxes, [kind](const LogSample& sample) { return readingOf(kind, sample); }});
  return hypotheses;
}

std::vector<Hypothesis> exchangeHypotheses() {
  std::vector<Hypothesis> hypotheses;
  for (const Quaternion& q : exchanges())
    hypotheses.push_back({Aspect::kAxes, [q](const LogSample&) {
                            return std::optional(turnReading(TurnedAxes::kBoth, q, both(q), Columns::kAll));
                          }});
  return hypotheses;
}

Hypothesis twoTurnsHypothesis() { return {Aspect::kAxes, twoTurns}; }

}  // namespace poinsot::reference
