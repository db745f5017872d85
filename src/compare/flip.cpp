// SPDX-License-Identifier: Apache-2.0
// FLIP for pictures of low dynamic range. A pixel's error combines a colour error and a feature error. Both are
// computed from a sliding window of rows in the linear opponent space Y Cx Cz. For the colour error, rows are
// blurred with the eye's contrast sensitivity, converted to linear RGB, and compared in Hunt-adjusted CIELab. For
// the feature error, edges and points are detected in the unblurred luminance.
#include "compare/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "compare/flip_stages.h"
#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {
namespace {

using Row = std::vector<double>;

template <typename Sample>
const std::vector<double>& linearTable() {
  static const std::vector<double> table = [] {
    constexpr std::size_t kMost = image::BasicImage<Sample>::kMost;
    std::vector<double> values(kMost + 1);
    for (std::size_t v = 0; v <= kMost; ++v) values[v] = linearLight(static_cast<double>(v) / kMost);
    return values;
  }();
  return table;
}

enum Plane { kY, kCx, kCz, kPlanes };

template <typename Sample>
RowWindow opponentWindow(const image::BasicImage<Sample>& picture, int radius) {
  return {picture.size, kPlanes, radius, [&picture](int y, const std::vector<double*>& planes) {
            const auto& linear = linearTable<Sample>();
            const Sample* p = picture.at(0, y);
            for (int x = 0; x < picture.size.width; ++x, p += picture.channels) {
              const Triple color = opponentColor({linear[p[0]], linear[p[1]], linear[p[2]]});
              for (std::size_t k = 0; k < kPlanes; ++k) planes[k][x] = color[k];
            }
          }};
}

/// Row of a picture as the eye perceives it: the colour, and the strengths of edges and points, at each pixel.
class PerceivedRows {
 public:
  template <typename Sample>
  PerceivedRows(const image::BasicImage<Sample>& picture, double pixelsPerDegree)
      : window_(opponentWindow(picture, flipRadius(pixelsPerDegree))),
        sensitivity_(contrastSensitivity(pixelsPerDegree)),
        features_(featureKernels(pixelsPerDegree)) {
    const auto width = static_cast<std::size_t>(picture.size.width);
    for (Row* row :
         {&column_, &smoothed_, &along_, &across_, &edge_, &point_, &blurred_[kY], &blurred_[kCx], &blurred_[kCz]})
      row->resize(width);
  }

  void moveTo(int y) {
    window_.moveTo(y);
    for (std::size_t k = 0; k < kPlanes; ++k) blur(static_cast<int>(k));
    findFeatures();
  }

  Triple color(std::size_t x) const {
    return huntLab(rgbOfOpponent({blurred_[kY][x], blurred_[kCx][x], blurred_[kCz][x]}));
  }
  double edge(std::size_t x) const { return edge_[x]; }
  double point(std::size_t x) const { return point_[x]; }

 private:
  void blur(int plane) {
    Row& out = blurred_[static_cast<std::size_t>(plane)];
    std::fill(out.begin(), out.end(), 0.0);
    for (const SensitivityPart& part : sensitivity_[static_cast<std::size_t>(plane)]) {
      filter(plane, part.profile, part.profile, along_);
      std::ranges::transform(out, along_, out.begin(),
                             [&](double sum, double v) { return sum + part.weight * v; });
    }
  }

  /// Computes the strengths of edges and points. Each strength is the length of a gradient, whose components are
  /// filter responses along x and along y. Each response is smoothed in the other direction.
  void findFeatures() {
    features_.smooth.alongColumns(window_, kY, smoothed_.data());
    findFeature(features_.edge, edge_);
    findFeature(features_.point, point_);
  }

  void findFeature(const Kernel& profile, Row& length) {
    profile.alongRow(smoothed_.data(), window_.width(), along_.data());
    filter(kY, profile, features_.smooth, across_);
    // Luminance is (Y + 16) / 116. The 16 cancels, because the weights of a profile sum to 0.
    std::ranges::transform(along_, across_, length.begin(),
                           [](double x, double y) { return std::sqrt(x * x + y * y) / 116; });
  }

  void filter(int plane, const Kernel& alongY, const Kernel& alongX, Row& out) {
    alongY.alongColumns(window_, plane, column_.data());
    alongX.alongRow(column_.data(), window_.width(), out.data());
  }

  RowWindow window_;
  std::array<std::vector<SensitivityPart>, kPlanes> sensitivity_;
  FeatureKernels features_;
  Row column_, smoothed_, along_, across_, edge_, point_;
  std::array<Row, kPlanes> blurred_;
};

double pixelError(const PerceivedRows& a, const PerceivedRows& b, std::size_t x) {
  const double color = colorError(a.color(x), b.color(x));
  const double feature = std::max(std::abs(a.edge(x) - b.edge(x)), std::abs(a.point(x) - b.point(x)));
  if (color == 0) return 0;
  return std::pow(color, 1 - std::sqrt(feature / std::numbers::sqrt2));
}

template <typename Sample>
void flipInto(double* error, const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
              double pixelsPerDegree) {
  PerceivedRows rowsA(a, pixelsPerDegree), rowsB(b, pixelsPerDegree);
  for (int y = 0; y < a.size.height; ++y) {
    rowsA.moveTo(y);
    rowsB.moveTo(y);
    for (std::size_t x = 0; x < static_cast<std::size_t>(a.size.width); ++x)
      *error++ = pixelError(rowsA, rowsB, x);
  }
}

/// Rectangle of pixels that includes x1 and y1.
struct Box {
  int x0, y0, x1, y1;

  Box grown(int by, image::PixelSize size) const {
    return {std::max(x0 - by, 0), std::max(y0 - by, 0), std::min(x1 + by, size.width - 1),
            std::min(y1 + by, size.height - 1)};
  }
  image::PixelSize size() const { return {x1 - x0 + 1, y1 - y0 + 1}; }
};

template <typename Sample>
std::optional<Box> differingBox(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b) {
  std::optional<Box> box;
  for (int y = 0; y < a.size.height; ++y) {
    core::checkInterruption();
    const Sample *p = a.at(0, y), *q = b.at(0, y);
    for (int x = 0; x < a.size.width; ++x, p += a.channels, q += b.channels) {
      if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) continue;
      if (!box) box = Box{x, y, x, y};
      *box = {std::min(box->x0, x), box->y0, std::max(box->x1, x), y};
    }
  }
  return box;
}

template <typename Sample>
image::BasicImage<Sample> cutOut(const image::BasicImage<Sample>& picture, const Box& box) {
  image::BasicImage<Sample> out(box.size(), 3);
  for (int y = box.y0; y <= box.y1; ++y) {
    core::checkInterruption();
    for (int x = box.x0; x <= box.x1; ++x) std::copy_n(picture.at(x, y), 3, out.at(x - box.x0, y - box.y0));
  }
  return out;
}

template <typename Sample>
FlipMap flipOf(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b, double pixelsPerDegree) {
  POINSOT_EXPECT(a.size == b.size && !a.pixels.empty() && pixelsPerDegree > 0);
  const auto width = static_cast<std::size_t>(a.size.width);
  FlipMap map{a.size, Row(width * static_cast<std::size_t>(a.size.height))};
  const auto differing = differingBox(a, b);
  if (!differing) return map;
  // Errors occur only in `wrong`, because they spread only as far as the filters reach. They are exact, because
  // `seen` holds all pixels that the filters read.
  const int radius = flipRadius(pixelsPerDegree);
  const Box wrong = differing->grown(radius, a.size), seen = wrong.grown(radius, a.size);
  const image::PixelSize size = seen.size();
  Row error(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  flipInto(error.data(), cutOut(a, seen), cutOut(b, seen), pixelsPerDegree);
  for (int y = wrong.y0; y <= wrong.y1; ++y)
    std::copy_n(&error[static_cast<std::size_t>((y - seen.y0) * size.width + wrong.x0 - seen.x0)],
                wrong.size().width,
                &map.error[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(wrong.x0)]);
  return map;
}

/// Quantiles weighted by value. at(share) returns the smallest value at which the running sum of the sorted values
/// exceeds `share` times the total.
class WeightedQuantiles {
 public:
  explicit WeightedQuantiles(const std::vector<double>& values) : bins_(kBins) {
    constexpr std::size_t kCheckedAtOnce = 1 << 16;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i % kCheckedAtOnce == 0) core::checkInterruption();
      bins_[binOf(values[i])].push_back(values[i]);
      total_ += values[i];
    }
  }

  double at(double share) {
    double sum = 0;
    for (auto& bin : bins_) {
      core::checkInterruption();
      const double above = sum + std::accumulate(bin.begin(), bin.end(), 0.0);
      if (above > share * total_) return within(bin, sum, share * total_);
      sum = above;
    }
    return 0;
  }

 private:
  static constexpr std::size_t kBins = 1024;  // number of bins; only one bin is sorted for a quantile

  static std::size_t binOf(double value) { return std::min(static_cast<std::size_t>(value * kBins), kBins - 1); }

  static double within(std::vector<double>& bin, double sum, double wanted) {
    std::sort(bin.begin(), bin.end());
    for (const double value : bin)
      if ((sum += value) > wanted) return value;
    return bin.back();
  }

  std::vector<std::vector<double>> bins_;
  double total_ = 0;
};

}  // namespace

double FlipMap::mean() const {
  return std::accumulate(error.begin(), error.end(), 0.0) / static_cast<double>(error.size());
}

double FlipMap::max() const { return *std::max_element(error.begin(), error.end()); }

FlipFigures figuresOf(const FlipMap& map, std::optional<std::int64_t> pixels) {
  WeightedQuantiles quantiles(map.error);
  const auto all = static_cast<double>(map.error.size());
  const double mean = pixels && *pixels > 0 ? map.mean() * (all / static_cast<double>(*pixels)) : map.mean();
  return {mean,
          *std::min_element(map.error.begin(), map.error.end()),
          quantiles.at(0.25),
          quantiles.at(0.5),
          quantiles.at(0.75),
          map.max()};
}

FlipMap flip(const image::Image& a, const image::Image& b, double pixelsPerDegree) {
  return flipOf(a, b, pixelsPerDegree);
}

FlipMap flip(const image::DeepImage& a, const image::DeepImage& b, double pixelsPerDegree) {
  return flipOf(a, b, pixelsPerDegree);
}

}  // namespace poinsot::compare
