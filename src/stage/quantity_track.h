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

/// The least and the largest value of a film, and what its rounding is measured by (StateQuantity::size). SI.
struct QuantityRange {
  double low = 0, high = 0, size = 0;
};

/// Both, for films that are to be compared.
QuantityRange joined(const QuantityRange& a, const QuantityRange& b);
/// Whether the values differ by more than rounding, and by more than six digits show.
bool varies(const QuantityRange& range);
/// The largest absolute value; of what is zero but for rounding, what its size could be.
double sizeOf(const QuantityRange& range);

/// Quantities of a scene's motion over its film: sampled once, evenly and densely enough that angles can be
/// followed through their jumps, and exact at any time.
class QuantityTrack {
 public:
  /// `motion`: drawnMotion() of the scene. `quantities`: indices into scene::stateQuantities().
  QuantityTrack(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion,
                std::vector<int> quantities);

  std::size_t samples() const { return filmTimes_s_.size(); }
  double filmTime_s(std::size_t sample) const { return filmTimes_s_[sample]; }
  /// Of the `which`-th quantity, SI; NaN where it does not exist.
  double sample(std::size_t which, std::size_t sample) const { return values_[which][sample]; }

  /// Exact, on the branch of the samples around it.
  double at(std::size_t which, double filmTime_s) const;
  /// Of all quantities together.
  QuantityRange range() const;
  QuantityRange range(std::size_t which) const { return ranges_[which]; }

  double motionTime_s(double filmTime_s) const { return clock_.motionTime_s(filmTime_s); }
  double duration_s() const { return duration_s_; }
  const scene::StateQuantity& quantity(std::size_t which) const {
    return scene::stateQuantity(quantities_[which]);
  }
  /// What pictures of the scene call it.
  std::string tex(std::size_t which) const { return scene::quantityTex(quantities_[which], basis_.forcing()); }
  std::size_t quantities() const { return quantities_.size(); }

  /// However long the film and fast the motion.
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
