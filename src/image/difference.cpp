// SPDX-License-Identifier: Apache-2.0
#include "image/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/error.h"
#include "core/expect.h"

namespace poinsot::image {
namespace {

template <typename Sample>
std::string shape(const BasicImage<Sample>& image) {
  return fmt::format("{}x{} with {} channels", image.size.width, image.size.height, image.channels);
}

template <typename Sample>
void checkComparable(const BasicImage<Sample>& a, const BasicImage<Sample>& b) {
  if (a.size == b.size && a.channels == b.channels) return;
  throw core::Error(core::ErrorKind::kIo,
                    fmt::format("pictures of different shape cannot be compared: {} and {}", shape(a), shape(b)));
}

/// Steps of a sample that are 1/255.
template <typename Sample>
constexpr double kStep = BasicImage<Sample>::kMost / 255.0;

/// Keeps the few largest of what it is shown.
class Worst {
 public:
  /// Whether a pixel of that difference would be kept.
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

/// What is counted and summed over the pixels, in the samples' own steps.
template <typename Sample>
class Sums {
 public:
  explicit Sums(int channels) : channels_(channels) {}

  void add(int x, int y, const Sample* p, const Sample* q) {
    int largest = 0;
    for (int c = 0; c < channels_; ++c) {
      const int delta = std::abs(p[c] - q[c]);
      largest = std::max(largest, delta);
      sum_ += delta;
      squares_ += std::int64_t{delta} * delta;
    }
    if (largest == 0) return;
    ++differing_;
    if (worst_.wants(largest)) worst_.add(largest, pixel(x, y, largest, p, q));
  }

  ImageDifference figures(double pixels) const {
    const double values = pixels * channels_;
    ImageDifference d;
    d.differingPixels = differing_;
    d.differingShare = static_cast<double>(differing_) / pixels;
    d.meanAbs = static_cast<double>(sum_) / values / kStep<Sample>;
    d.rmse = std::sqrt(static_cast<double>(squares_) / values) / kStep<Sample>;
    d.worst = worst_.pixels();
    if (differing_ == 0) return d;
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
  std::int64_t differing_ = 0, sum_ = 0, squares_ = 0;
  Worst worst_;
};

template <typename Sample>
Comparison compared(const BasicImage<Sample>& a, const BasicImage<Sample>& b, double pixelsPerDegree) {
  checkComparable(a, b);
  Sums<Sample> sums(a.channels);
  for (int y = 0; y < a.size.height; ++y) {
    const Sample *p = a.at(0, y), *q = b.at(0, y);
    for (int x = 0; x < a.size.width; ++x, p += a.channels, q += a.channels) sums.add(x, y, p, q);
  }
  Comparison made{sums.figures(static_cast<double>(a.size.width) * a.size.height), flip(a, b, pixelsPerDegree)};
  made.difference.ssim = ssim(a, b);
  made.difference.flip = figuresOf(made.flip);
  return made;
}

DeepImage deepened(const AnyImage& picture) {
  if (const auto* deep = std::get_if<DeepImage>(&picture)) return *deep;
  const Image& flat = std::get<Image>(picture);
  DeepImage out(flat.size, flat.channels);
  constexpr int kRepeated = 257;  // 255 becomes 65535
  std::transform(flat.pixels.begin(), flat.pixels.end(), out.pixels.begin(),
                 [](std::uint8_t v) { return static_cast<std::uint16_t>(kRepeated * v); });
  return out;
}

bool isDeep(const AnyImage& picture) { return std::holds_alternative<DeepImage>(picture); }

template <typename Sample>
Image amplified(const BasicImage<Sample>& a, const BasicImage<Sample>& b, int factor) {
  checkComparable(a, b);
  POINSOT_EXPECT(factor > 0);
  Image out(a.size, 3);
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const double difference = factor * std::abs(a.at(x, y)[c] - b.at(x, y)[c]) / kStep<Sample>;
        out.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(std::min(255.0, difference)));
      }
  return out;
}

}  // namespace

Comparison compare(const Image& a, const Image& b, double pixelsPerDegree) {
  return compared(a, b, pixelsPerDegree);
}

Comparison compare(const DeepImage& a, const DeepImage& b, double pixelsPerDegree) {
  return compared(a, b, pixelsPerDegree);
}

Comparison compare(const AnyImage& a, const AnyImage& b, double pixelsPerDegree) {
  if (isDeep(a) || isDeep(b)) return compared(deepened(a), deepened(b), pixelsPerDegree);
  return compared(std::get<Image>(a), std::get<Image>(b), pixelsPerDegree);
}

Image amplifiedDifference(const Image& a, const Image& b, int factor) { return amplified(a, b, factor); }

Image amplifiedDifference(const AnyImage& a, const AnyImage& b, int factor) {
  if (isDeep(a) || isDeep(b)) return amplified(deepened(a), deepened(b), factor);
  return amplified(std::get<Image>(a), std::get<Image>(b), factor);
}

}  // namespace poinsot::image
