// SPDX-License-Identifier: Apache-2.0
#include "physics/step_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/interruption.h"

namespace poinsot::physics {
namespace {

// Largest turn in one step. In space, a torque fixed in the body varies as fast as the body turns. After a full
// turn, the torque is the same again, and the error of so long a step would not be noticed.
constexpr double kLongestTurn_rad = 1;

// If energy is not conserved, a piece is divided into parts. kStepsPerPart is the smallest number of pilot steps
// in a part, kMostPartsOfPiece the largest number of parts.
constexpr std::size_t kStepsPerPart = 32, kMostPartsOfPiece = 16;

// Angular momentum below this fraction of the largest so far counts as 0. Otherwise, the pilot would follow the
// decay of a body at rest down to the smallest doubles, which have few digits.
constexpr double kAtRest = 1e-12;

// Smallest number of steps of a `finer` run (DrivenTrajectory) for each pilot step.
constexpr double kFiner = 4.0 / 3;

/// Step of the pilot. since_s is its start, measured from the start of the piece. length_s is the accepted length,
/// which may pass the end of the piece. If atRest, the body is at rest until the end of the piece.
struct PilotStep {
  double since_s = 0;
  double length_s = 0;
  bool atRest = false;
};

/// Returns the angle between two attitudes in rad, plus the difference of the angular momenta divided by `scale`.
double difference(const DrivenState& a, const DrivenState& b, double scale) {
  const Rotor<double> turn = conjugate(toDouble(a.q_WP)) * toDouble(b.q_WP);
  const double angle = 2 * std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
  const double L = norm({a.L_W[0].hi - b.L_W[0].hi, a.L_W[1].hi - b.L_W[1].hi, a.L_W[2].hi - b.L_W[2].hi});
  return angle + (scale > 0 ? L / scale : 0);
}

double size(const DrivenState& s) { return norm({s.L_W[0].hi, s.L_W[1].hi, s.L_W[2].hi}); }

class Pilot {
 public:
  Pilot(const Splitting& splitting, const Composition& composition, const DrivenState& start, double allowedSteps)
      : splitting_(splitting),
        composition_(composition),
        most_(mostSteps(composition, allowedSteps)),
        state_(start),
        largest_(size(start)) {}

  std::vector<PilotStep> over(const ForcingPiece& piece);

  double turned_rad() const { return turned_; }

 private:
  double longest() const;
  double tried(const ForcingPiece& piece, double since, double h, DrivenState& after) const;
  void refuseIfHopeless(const ForcingPiece& piece, double since) const;

  const Splitting& splitting_;
  const Composition& composition_;
  double most_;
  DrivenState state_;
  double largest_;
  double h_ = 0;  // step length, kept from piece to piece; 0 before the first piece
  double taken_ = 0;
  double turned_ = 0;
};

double Pilot::longest() const {
  const double rate = splitting_.fastestRate(state_);
  return rate > 0 ? kLongestTurn_rad / rate : HUGE_VAL;
}

/// Returns the error of a step of signed length h, estimated by two half steps. Sets `after` to the state after
/// the two half steps.
double Pilot::tried(const ForcingPiece& piece, double since, double h, DrivenState& after) const {
  DrivenState once = state_;
  after = state_;
  splitting_.step(once, composition_, piece, since, h);
  splitting_.step(after, composition_, piece, since, 0.5 * h);
  splitting_.step(after, composition_, piece, since + 0.5 * h, 0.5 * h);
  const double turned = splitting_.angularSpeed(after) * std::abs(h);
  const double scale = std::max({size(state_), size(after), kAtRest * largest_});
  const double error = difference(once, after, scale);
  return turned > 2 * kLongestTurn_rad ? HUGE_VAL : error;
}

void Pilot::refuseIfHopeless(const ForcingPiece& piece, double since) const {
  const double t = piece.begin_s + since;
  const double rest = std::min(std::abs(piece.end_s - t), splitting_.untilRest_s(state_, piece));
  const bool endless = !(h_ > 0x1p-50 * std::abs(t) && h_ > 0);
  if (!endless && taken_ + rest / h_ < 4 * most_ && kFiner * taken_ <= most_) return;
  throw core::Error(endless ? core::ErrorKind::kPhysics : core::ErrorKind::kLimit,
                    fmt::format("the driven motion needs steps of {:.3g} s at t = {:.6g} s, with {:.6g} s to go: "
                                "more than the {:.0f} steps allowed in a run; shorten the run, or weaken what "
                                "drives the body",
                                h_, t, rest, most_));
}

std::vector<PilotStep> Pilot::over(const ForcingPiece& piece) {
  const double length = std::abs(piece.end_s - piece.begin_s), sense = piece.end_s < piece.begin_s ? -1 : 1;
  // A window of a force can be as short as a blow. The step that fits the blow would be far too short after it.
  if (h_ == 0 || piece.hasForces) h_ = length;
  std::vector<PilotStep> steps;
  DrivenState after;
  for (double since = 0; since < length;) {
    core::checkInterruption();
    if (splitting_.untilRest_s(state_, piece) <= 0) {
      steps.push_back({sense * since, HUGE_VAL, true});
      break;
    }
    h_ = std::min(h_, longest());
    const double h = std::min(h_, length - since);
    const double error = tried(piece, sense * since, sense * h, after);
    if (!(error <= kPilotError)) {
      h_ = 0.5 * h;
      refuseIfHopeless(piece, sense * since);
      continue;
    }
    steps.push_back({sense * since, h_});
    state_ = after;
    largest_ = std::max(largest_, size(state_));
    turned_ += splitting_.angularSpeed(state_) * h;
    since = h < h_ || since + h >= length ? length : since + h;
    taken_ += 1;
    refuseIfHopeless(piece, sense * since);
    if (h == h_ && std::ldexp(error, composition_.order + 2) < kPilotError) h_ *= 2;
  }
  return steps;
}

Stretch stretchOf(const ForcingPiece& piece, const std::vector<PilotStep>& steps, std::size_t first,
                  std::size_t last) {
  Stretch stretch{piece, piece.begin_s + steps[first].since_s,
                  last < steps.size() ? piece.begin_s + steps[last].since_s : piece.end_s, HUGE_VAL,
                  steps[first].atRest};
  for (std::size_t i = first; i < last; ++i) stretch.step_s = std::min(stretch.step_s, steps[i].length_s);
  return stretch;
}

}  // namespace

StepPlan pilotPlan(const Splitting& splitting, const Composition& composition, const DrivenState& start,
                   const std::vector<ForcingPiece>& pieces, bool conservative, double allowedSteps) {
  Pilot pilot(splitting, composition, start, allowedSteps);
  StepPlan plan;
  for (const ForcingPiece& piece : pieces) {
    const std::vector<PilotStep> steps = pilot.over(piece);
    const bool rests = !steps.empty() && steps.back().atRest;
    const std::size_t n = steps.size() - (rests ? 1 : 0);
    const std::size_t parts = conservative ? 1 : std::clamp<std::size_t>(n / kStepsPerPart, 1, kMostPartsOfPiece);
    for (std::size_t i = 0; i < parts && n > 0; ++i)
      plan.stretches.push_back(stretchOf(piece, steps, i * n / parts, (i + 1) * n / parts));
    if (rests) plan.stretches.push_back(stretchOf(piece, steps, n, n + 1));
  }
  plan.turned_rad = pilot.turned_rad();
  return plan;
}

double mostSteps(const Composition& composition, double allowed) {
  return composition.ofSymmetricSteps ? std::floor(allowed / 5) : allowed;
}

double stepsIn(const Stretch& stretch, double scale, double fewest) {
  return std::max(fewest, std::ceil(std::abs(stretch.end_s - stretch.begin_s) / (stretch.step_s * scale)));
}

}  // namespace poinsot::physics
