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

/// Least and largest value of a quantity over a film, and the size that its rounding is measured by
/// (StateQuantity::size). SI.
struct QuantityRange {
  double low = 0, high = 0, size = 0;
};

/// Returns a range that holds both ranges, for films that are to be compared.
QuantityRange joined(const QuantityRange& a, const QuantityRange& b);
/// Returns true if the values vary by more than rounding, and by enough to be seen in six digits.
bool varies(const QuantityRange& range);
/// Returns the largest absolute value. For values that are zero except for rounding: the size they could have.
double sizeOf(const QuantityRange& range);

/// Quantities of a scene's motion over its film. The samples are even, and dense enough to follow angles through
/// their jumps. Values at other times are exact, not interpolated.
class QuantityTrack {
 public:
  /// @param motion  drawnMotion() of the scene
  /// @param quantities  indices into scene::stateQuantities()
  QuantityTrack(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion,
                std::vector<int> quantities);

  std::size_t samples() const { return filmTimes_s_.size(); }
  double filmTime_s(std::size_t sample) const { return filmTimes_s_[sample]; }
  /// Returns a sample of the `which`-th quantity, SI; NaN if the quantity does not exist at that time.
  double sample(std::size_t which, std::size_t sample) const { return values_[which][sample]; }

  /// Returns the exact value, on the branch of the samples around that time.
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
