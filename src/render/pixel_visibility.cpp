// SPDX-License-Identifier: Apache-2.0
#include "render/pixel_visibility.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace poinsot::render {
namespace {

constexpr std::size_t kSamples = 64;
// Of the area that the samples find inside one edge.
constexpr double kCoverageError = 0.02;

/// Hammersley's points: one in each of 64 columns and rows, so that an upright edge is seen as well as a slanting
/// one.
struct SamplePoints {
  std::array<float, kSamples> x{}, y{};
  constexpr SamplePoints() {
    for (std::size_t i = 0; i < kSamples; ++i) {
      std::size_t reversed = 0;
      for (std::size_t bit = 0; bit < 6; ++bit) reversed |= (i >> bit & 1) << (5 - bit);
      x[i] = (static_cast<float>(i) + 0.5f) / kSamples;
      y[i] = (static_cast<float>(reversed) + 0.5f) / kSamples;
    }
  }
};
constexpr SamplePoints kPoints;

/// The nearest fragment at each sample.
class SampleDepths {
 public:
  SampleDepths() {
    nearest_.fill(-std::numeric_limits<float>::infinity());
    winners_.fill(-1);
  }

  /// @return at how many samples the fragment lies.
  int add(const PixelFragment& f, int number) {
    const glm::vec3 a(f.edges[0]), b(f.edges[1]), c(f.edges[2]), q(f.nearness);
    const auto least = static_cast<float>(f.farthest), most = static_cast<float>(f.nearest);
    int count = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const float x = kPoints.x[i], y = kPoints.y[i];
      const bool inside =
          (a.x * x + a.y * y + a.z >= 0) & (b.x * x + b.y * y + b.z >= 0) & (c.x * x + c.y * y + c.z >= 0);
      const float nearness = std::min(std::max(q.x * x + q.y * y + q.z, least), most);
      const bool wins = inside & (nearness > nearest_[i]);
      count += inside;
      nearest_[i] = wins ? nearness : nearest_[i];
      winners_[i] = wins ? number : winners_[i];
    }
    return count;
  }

  int wins(int number) const { return static_cast<int>(std::count(winners_.begin(), winners_.end(), number)); }
  /// The share of the pixel that anything covers.
  double covered() const { return 1 - static_cast<double>(wins(-1)) / kSamples; }

 private:
  std::array<float, kSamples> nearest_;  // nearness
  std::array<int, kSamples> winners_;
};

// A part too small for any sample is judged by its middle.
bool isHidden(const PixelFragment& f, std::span<const PixelFragment> fragments) {
  const double own = f.nearnessAt(f.middle);
  return std::any_of(fragments.begin(), fragments.end(), [&](const PixelFragment& other) {
    return &other != &f && other.holds(f.middle) && other.nearnessAt(f.middle) > own;
  });
}

double total(std::span<const PixelFragment> fragments) {
  return std::accumulate(fragments.begin(), fragments.end(), 0.0,
                         [](double sum, const PixelFragment& f) { return sum + f.area; });
}

// Many small folds are hidden by less than a sample each: their sum must not stray from what the samples cover.
void holdTo(double covered, std::vector<double>& areas) {
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double held = std::clamp(sum, covered - kCoverageError, covered + kCoverageError);
  if (sum > 0)
    for (double& area : areas) area *= held / sum;
}

}  // namespace

std::vector<double> visibleAreas(std::span<const PixelFragment> fragments) {
  SampleDepths samples;
  std::vector<int> counts;
  for (const PixelFragment& f : fragments) counts.push_back(samples.add(f, static_cast<int>(counts.size())));
  const bool full = samples.covered() == 1;
  std::vector<double> areas;
  std::vector<bool> estimated;
  double open = 0, partlyHidden = 0;  // total areas
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const PixelFragment& f = fragments[i];
    const int wins = samples.wins(static_cast<int>(i));
    estimated.push_back(wins < counts[i]);
    double share = 1;
    if (estimated.back())
      // A filled pixel is filled below: none of few samples must not mean nothing then (rule of succession).
      share = full ? (wins + 0.5) / (counts[i] + 1) : static_cast<double>(wins) / counts[i];
    else if (counts[i] == 0 && isHidden(f, fragments))
      share = 0;
    areas.push_back(share * f.area);
    (estimated.back() ? partlyHidden : open) += areas.back();
  }
  // What is partly hidden takes the room that the rest leaves.
  const double room = std::max(1 - open, 0.0);
  const bool fit = partlyHidden > 0 && (full || partlyHidden > room);
  const double stretch = fit ? room / partlyHidden : 1, shrink = open > 1 ? 1 / open : 1;
  for (std::size_t i = 0; i < areas.size(); ++i) areas[i] *= estimated[i] ? stretch : shrink;
  if (open < total(fragments)) holdTo(samples.covered(), areas);
  return areas;
}

}  // namespace poinsot::render
