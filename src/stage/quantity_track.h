// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "physics/motion.h"
#include "scene/motion/film_clock.h"
#include "scene/scene.h"
#include "scene/state_quantity.h"

namespace poinsot::stage {

/// Smallest and largest value of a quantity over a film, in SI units. `size` is the magnitude that rounding errors
/// are relative to (StateQuantity::size).
struct QuantityRange {
  double low = 0, high = 0, size = 0;
};

/// Returns the smallest range that contains both ranges. Films that are compared share such a range.
QuantityRange joined(const QuantityRange& a, const QuantityRange& b);
/// Returns true if the values vary by more than rounding errors, and enough to be visible in six digits.
bool varies(const QuantityRange& range);
/// Returns the largest absolute value in the range. If all values are zero up to rounding errors, returns the
/// magnitude that they could have.
double sizeOf(const QuantityRange& range);

/// Values of some quantities over a scene's film. The samples are evenly spaced, and dense enough to follow an
/// angle across its jumps by a full turn. Values between the samples are computed exactly, not interpolated.
class QuantityTrack {
 public:
  /// @param motion  drawnMotion() of the scene. If angles are exaggerated, the values are those of the scene's own
  /// motion instead.
  /// @param quantities  indices into scene::stateQuantities()
  QuantityTrack(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion,
                std::vector<int> quantities);

  std::size_t samples() const { return filmTimes_s_.size(); }
  double filmTime_s(std::size_t sample) const { return filmTimes_s_[sample]; }
  /// Returns a sample of the `which`-th quantity, SI; NaN if the quantity does not exist at that time.
  double sample(std::size_t which, std::size_t sample) const { return values_[which][sample]; }

  /// Returns the exact value at any film time. The number of full turns, or the sign, agrees with the nearby
  /// samples.
  double at(std::size_t which, double filmTime_s) const;
  QuantityRange range() const;
  QuantityRange range(std::size_t which) const { return ranges_[which]; }

  double motionTime_s(double filmTime_s) const { return clock_.motionTime_s(filmTime_s); }
  double duration_s() const { return duration_s_; }
  const scene::StateQuantity& quantity(std::size_t which) const {
    return scene::stateQuantity(quantities_[which]);
  }
  std::string tex(std::size_t which) const { return scene::quantityTex(quantities_[which], basis_.forcing()); }
  std::size_t quantities() const { return quantities_.size(); }

  static constexpr std::size_t kMostSamples = std::size_t{1} << 18;

 private:
  void chooseTimes(const scene::Scene& scene);
  void sampleAll();

  std::shared_ptr<const physics::Motion> motion_;
  std::vector<int> quantities_;
  scene::FilmClock clock_;
  double duration_s_;
  scene::QuantityBasis basis_;
  std::vector<double> filmTimes_s_;
  std::vector<std::vector<double>> values_;
  std::vector<QuantityRange> ranges_;
};

}  // namespace poinsot::stage
