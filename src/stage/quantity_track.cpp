// SPDX-License-Identifier: Apache-2.0
#include "stage/quantity_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scene/motion/quantity_basis.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {
namespace {

using scene::QuantityBranch;

// Gives 25 samples per turn of the body. An angle that turns twice as fast as the body still gets 12 per turn.
constexpr double kSamplesPerRadian = 4;
constexpr int kSpeedPoints = 500;
constexpr std::size_t kSamplesPerPixel = 4, kLeastSamples = 2000;

/// Returns the equivalent value that is nearest to `to`. Equivalent values differ by full turns or by their sign,
/// depending on the branch.
double nearest(QuantityBranch branch, double value, double to) {
  if (!std::isfinite(to)) return value;
  if (branch == QuantityBranch::kTurns) {
    const double turn = 2 * std::numbers::pi;
    return value + turn * std::round((to - value) / turn);
  }
  if (branch == QuantityBranch::kSign) return std::abs(value - to) <= std::abs(-value - to) ? value : -value;
  return value;
}

/// Changes the sign of a quaternion if that brings it nearer to `of`. Compares all components, because a single
/// component can be zero.
void takeSign(physics::Quaternion& q, const physics::Quaternion& of) {
  if (q.dot(of) < 0) q.coeffs() = -q.coeffs();
}

void widen(QuantityRange& range, double value, double size) {
  if (!std::isfinite(value)) return;
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
  range.size = std::max(range.size, size);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kRounding =
    1e-11;                      // relative error of a quantity if the motion is integrated with tolerance 1e-12
constexpr double kFlat = 1e-5;  // change relative to the value; smaller changes need more than six digits

double largestOf(const QuantityRange& range) { return std::max(std::abs(range.low), std::abs(range.high)); }

/// Returns the scene's own motion. The drawn motion differs from it if angles are exaggerated.
std::shared_ptr<const physics::Motion> measured(const scene::Scene& scene,
                                                std::shared_ptr<const physics::Motion> drawn) {
  if (scene.show.exaggerateAngles == 1) return drawn;
  scene::Scene own = scene;
  own.show.exaggerateAngles = 1;
  return drawnMotion(own);
}

}  // namespace

QuantityRange joined(const QuantityRange& a, const QuantityRange& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high), std::max(a.size, b.size)};
}

bool varies(const QuantityRange& range) {
  return range.high - range.low > std::max(kRounding * range.size, kFlat * largestOf(range));
}

double sizeOf(const QuantityRange& range) {
  const double largest = largestOf(range);
  if (largest > kRounding * range.size) return largest;
  return range.size > 0 ? range.size : 1;
}

QuantityTrack::QuantityTrack(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion,
                             std::vector<int> quantities)
    : motion_(measured(scene, std::move(motion))),
      quantities_(std::move(quantities)),
      clock_(filmClock(scene)),
      duration_s_(scene.time.duration_s),
      basis_(scene::quantityBasis(scene, *motion_)) {
  chooseTimes(scene);
  sampleAll();
}

void QuantityTrack::chooseTimes(const scene::Scene& scene) {
  double fastest = 0;  // fastest rotation, rad per second of film
  for (int i = 0; i <= kSpeedPoints; ++i) {
    const double film_s = duration_s_ * (static_cast<double>(i) / kSpeedPoints);
    const double rate = std::abs(clock_.speed()) * clock_.pace(film_s);
    fastest = std::max(fastest, rate * motion_->at(motionTime_s(film_s)).omega_W.norm());
  }
  const double wanted = std::min(kSamplesPerRadian * fastest * duration_s_, static_cast<double>(kMostSamples));
  const std::size_t forWidth = kSamplesPerPixel * static_cast<std::size_t>(scene.output.width);
  const std::size_t count =
      std::clamp(std::max(forWidth, static_cast<std::size_t>(wanted)), kLeastSamples, kMostSamples);
  for (std::size_t i = 0; i < count; ++i)
    filmTimes_s_.push_back(duration_s_ * static_cast<double>(i) / static_cast<double>(count - 1));
}

void QuantityTrack::sampleAll() {
  values_.assign(quantities_.size(), {});
  ranges_.assign(quantities_.size(), {kInfinity, -kInfinity, 0});
  std::vector<double> last(quantities_.size(), std::numeric_limits<double>::quiet_NaN());
  physics::Quaternion before = motion_->at(clock_.motionTime_s(0)).q_WB;
  for (const double film_s : filmTimes_s_) {
    physics::RigidBodyState state = motion_->at(motionTime_s(film_s));
    takeSign(state.q_WB, before);
    before = state.q_WB;
    for (std::size_t i = 0; i < quantities_.size(); ++i) {
      const scene::StateQuantity& q = quantity(i);
      const bool turns = q.branch == QuantityBranch::kTurns;
      const double raw = q.value(state, basis_), value = turns ? nearest(q.branch, raw, last[i]) : raw;
      values_[i].push_back(value);
      if (std::isfinite(value)) last[i] = value;
      widen(ranges_[i], value, q.size ? q.size(state, basis_) : 1);
    }
  }
  for (QuantityRange& range : ranges_)
    if (range.low > range.high) range = {0, 0, 1};  // the quantity is undefined at all times
}

double QuantityTrack::at(std::size_t which, double filmTime_s) const {
  const double value = quantity(which).value(motion_->at(motionTime_s(filmTime_s)), basis_);
  const double share = std::clamp(filmTime_s / duration_s_, 0.0, 1.0);
  const double place = share * static_cast<double>(samples() - 1);
  const auto left = std::min(static_cast<std::size_t>(place), samples() - 2);
  const double along = place - static_cast<double>(left);
  const double between = std::lerp(sample(which, left), sample(which, left + 1), along);
  return nearest(quantity(which).branch, value, between);
}

QuantityRange QuantityTrack::range() const {
  QuantityRange all = ranges_.front();
  for (const QuantityRange& one : ranges_) {
    all.low = std::min(all.low, one.low);
    all.high = std::max(all.high, one.high);
    all.size = std::max(all.size, one.size);
  }
  return all;
}

}  // namespace poinsot::stage
