// SPDX-License-Identifier: Apache-2.0
#include "compare/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "compare/changed_pixels.h"
#include "compare/common_form.h"
#include "core/error.h"
#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {
namespace {

template <typename Sample>
std::string shape(const image::BasicImage<Sample>& image) {
  return fmt::format("{}x{} with {} channels", image.size.width, image.size.height, image.channels);
}

template <typename Sample>
void checkComparable(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b) {
  if (a.size == b.size && a.channels == b.channels) return;
  throw core::ioError(
      fmt::format("pictures of different shape cannot be compared: {} and {}", shape(a), shape(b)));
}

/// Number of steps of a sample type in 1/255 of its range: 1 for 8 bits, 257 for 16 bits.
template <typename Sample>
constexpr double kStep = image::BasicImage<Sample>::kMost / 255.0;

class Worst {
 public:
  bool wants(int difference) const { return kept_.size() < kMost || difference > kept_.back().first; }

  void add(int difference, const DifferingPixel& pixel) {
    const auto smaller = [&](const Entry& entry) { return entry.first < difference; };
    kept_.insert(std::find_if(kept_.begin(), kept_.end(), smaller), {difference, pixel});
    if (kept_.size() > kMost) kept_.pop_back();
  }

  std::vector<DifferingPixel> pixels() const {
    std::vector<DifferingPixel> pixels;
    for (const Entry& entry : kept_) pixels.push_back(entry.second);
    return pixels;
  }

 private:
  using Entry = std::pair<int, DifferingPixel>;
  static constexpr std::size_t kMost = 10;
  std::vector<Entry> kept_;
};

/// Counts and sums over the compared pixels, from which the figures are computed. Differences are in steps of the
/// sample type.
template <typename Sample>
class Sums {
 public:
  /// @param compared  number of compared pixels
  Sums(int channels, double level, std::int64_t compared)
      : channels_(channels), level_(level), compared_(compared) {}

  /// Adds a compared pixel that differs.
  void add(int x, int y, const Sample* p, const Sample* q) {
    int largest = 0;
    for (int c = 0; c < channels_; ++c) {
      const int delta = std::abs(p[c] - q[c]);
      largest = std::max(largest, delta);
      sum_ += delta;
      squares_ += std::int64_t{delta} * delta;
    }
    ++differing_;
    if (largest > level_ * kStep<Sample>) ++counted_;
    if (worst_.wants(largest)) worst_.add(largest, pixel(x, y, largest, p, q));
  }

  ImageDifference figures() const {
    ImageDifference d;
    d.comparedPixels = compared_;
    d.channels = channels_;
    d.level = level_;
    d.differingPixels = differing_;
    d.countedPixels = counted_;
    if (differing_ == 0) return d;
    const double pixels = static_cast<double>(compared_), values = pixels * channels_;
    d.differingShare = static_cast<double>(differing_) / pixels;
    d.meanAbs = static_cast<double>(sum_) / values / kStep<Sample>;
    d.rmse = std::sqrt(static_cast<double>(squares_) / values) / kStep<Sample>;
    d.worst = worst_.pixels();
    d.maxAbs = d.worst.front().difference;
    d.psnr_dB = 20 * std::log10(255 / d.rmse);
    return d;
  }

 private:
  DifferingPixel pixel(int x, int y, int difference, const Sample* p, const Sample* q) const {
    DifferingPixel pixel{x, y, difference / kStep<Sample>};
    std::copy_n(p, channels_, pixel.a.begin());
    std::copy_n(q, channels_, pixel.b.begin());
    return pixel;
  }

  int channels_;
  double level_;
  std::int64_t compared_, differing_ = 0, counted_ = 0, sum_ = 0, squares_ = 0;
  Worst worst_;
};

template <typename Sample>
ImageDifference summed(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                       const ComparisonOptions& options) {
  const IgnoreMask* const ignored = options.ignored;
  const std::int64_t pixels = std::int64_t{a.size.width} * a.size.height;
  Sums<Sample> sums(a.channels, options.level, ignored ? ignored->comparedPixels() : pixels);
  forEachChangedPixel(a, b, image::wholeOf(a.size), [&](int x, int y, const Sample* p, const Sample* q) {
    if (!ignored || !ignored->ignores(x, y)) sums.add(x, y, p, q);
  });
  return sums.figures();
}

struct Seen {
  FlipMap flip;
  std::optional<SsimFigures> ssim;
};

template <typename Sample>
Seen seenOf(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
            const ComparisonOptions& options) {
  return {flip(a, b, options.pixelsPerDegree), ssim(a, b, options.ignored)};
}

/// Combines the results on black and on white background: the larger FLIP error of each pixel, and the SSIM with
/// the smaller mean.
Seen larger(Seen dark, const Seen& light) {
  std::ranges::transform(dark.flip.error, light.flip.error, dark.flip.error.begin(),
                         [](double a, double b) { return std::max(a, b); });
  if (dark.ssim && light.ssim->mean < dark.ssim->mean) dark.ssim = light.ssim;
  return dark;
}

template <typename Sample>
Seen seenUponPapers(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                    const ComparisonOptions& options) {
  if (a.channels == 3) return seenOf(a, b, options);
  const auto upon = [&](Sample paper) { return seenOf(onPaper(a, paper), onPaper(b, paper), options); };
  return larger(upon(0), upon(image::BasicImage<Sample>::kMost));
}

/// Sets the errors of ignored pixels to 0. FLIP's filters spread errors of neighbouring pixels to them.
void clearIgnored(FlipMap& map, const IgnoreMask& ignored) {
  auto error = map.error.begin();
  for (int y = 0; y < map.size.height; ++y)
    for (int x = 0; x < map.size.width; ++x, ++error)
      if (ignored.ignores(x, y)) *error = 0;
}

template <typename Sample>
Comparison compared(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                    const ComparisonOptions& options) {
  checkComparable(a, b);
  const IgnoreMask* const ignored = options.ignored;
  POINSOT_EXPECT(!ignored || ignored->size() == a.size);
  Comparison made{summed(a, b, options), {}};
  Seen seen = ignored ? seenUponPapers(a, withIgnoredOf(a, b, *ignored), options) : seenUponPapers(a, b, options);
  made.flip = std::move(seen.flip);
  if (ignored) clearIgnored(made.flip, *ignored);
  made.difference.ssim = seen.ssim;
  made.difference.flip = figuresOf(made.flip, made.difference.comparedPixels);
  return made;
}

template <typename Sample>
image::Image amplified(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                       const IgnoreMask* ignored, int factor) {
  checkComparable(a, b);
  POINSOT_EXPECT(factor > 0);
  image::Image out(a.size, 3);
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x) {
      if (ignored && ignored->ignores(x, y)) continue;
      const Sample *p = a.at(x, y), *q = b.at(x, y);
      const int alpha = a.channels == 4 ? std::abs(p[3] - q[3]) : 0;
      for (int c = 0; c < 3; ++c) {
        const double difference = factor * std::max(alpha, std::abs(p[c] - q[c])) / kStep<Sample>;
        out.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(std::min(255.0, difference)));
      }
    }
  return out;
}

template <typename Use>
auto ofOneType(const image::AnyImage& a, const image::AnyImage& b, Use use) {
  POINSOT_EXPECT(a.index() == b.index());
  return std::visit([&](const auto& first) { return use(first, std::get<std::decay_t<decltype(first)>>(b)); }, a);
}

}  // namespace

Comparison compare(const image::Image& a, const image::Image& b, const ComparisonOptions& options) {
  return compared(a, b, options);
}

Comparison compare(const image::DeepImage& a, const image::DeepImage& b, const ComparisonOptions& options) {
  return compared(a, b, options);
}

Comparison compareCommon(const image::AnyImage& a, const image::AnyImage& b, const ComparisonOptions& options) {
  return ofOneType(a, b, [&](const auto& p, const auto& q) { return compared(p, q, options); });
}

Comparison compare(image::AnyImage a, image::AnyImage b, const ComparisonOptions& options) {
  toCommonForm(a, b);
  return compareCommon(a, b, options);
}

image::Image amplifiedDifference(const image::Image& a, const image::Image& b, const IgnoreMask* ignored,
                                 int factor) {
  return amplified(a, b, ignored, factor);
}

image::Image amplifiedDifference(image::AnyImage a, image::AnyImage b, const IgnoreMask* ignored, int factor) {
  toCommonForm(a, b);
  return ofOneType(a, b, [&](const auto& p, const auto& q) { return amplified(p, q, ignored, factor); });
}

}  // namespace poinsot::compare
