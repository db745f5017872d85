// SPDX-License-Identifier: Apache-2.0
// FLIP for pictures of low dynamic range. A pixel's error combines a colour error and a feature error. Both are
// computed from a sliding window of rows in the linear opponent space Y Cx Cz. For the colour error, rows are
// blurred with the eye's contrast sensitivity, converted to linear RGB, and compared in Hunt-adjusted CIELab. For
// the feature error, edges and points are detected in the unblurred luminance. Pixels that no filter connects with
// a differing pixel have the error 0 and are not computed.
#include "compare/flip.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>

#include "compare/affected_spans.h"
#include "compare/flip_color.h"
#include "compare/flip_stages.h"
#include "compare/row_arithmetic.h"
#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {
namespace {

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
            const double* const linear = linearTable<Sample>().data();
            const std::array<double*, kPlanes> color{planes[kY], planes[kCx], planes[kCz]};
            const Sample* p = picture.at(0, y);
            for (int x = 0; x < picture.size.width; ++x, p += picture.channels)
              for (std::size_t k = 0; k < kPlanes; ++k) color[k][x] = linear[p[k]];
            toOpponent(color, {0, picture.size.width});
          }};
}

/// Filter along the columns of a plane, with its results in a row.
struct ColumnFilter {
  Plane plane;
  Kernel kernel;
  MarginedRow row;
};

/// Perceived rows of a picture, from the top. Filters work along columns first, then along the resulting rows.
class PerceivedRows {
 public:
  template <typename Sample>
  PerceivedRows(const image::BasicImage<Sample>& picture, double pixelsPerDegree)
      : window_(opponentWindow(picture, flipRadius(pixelsPerDegree))), features_(featureKernels(pixelsPerDegree)) {
    const auto sensitivity = contrastSensitivity(pixelsPerDegree);
    for (const Plane plane : {kY, kCx, kCz})
      for (const SensitivityPart& part : sensitivity[plane]) {
        blurs_.push_back({plane, part.profile, empty_});
        weights_.push_back(part.weight);
      }
  }

  /// Computes row y in some spans of columns. @pre as RowWindow::moveTo()
  void moveTo(int y, const std::vector<ColumnSpan>& spans) {
    window_.moveTo(y);
    for (const ColumnSpan& span : spans) {
      filterColumns(span.grown(window_.radius()));
      blurRows(span);
      findFeatures(span);
    }
  }

  PerceivedRow row() const {
    return {
        {color_[kY].columns(), color_[kCx].columns(), color_[kCz].columns()}, edge_.columns(), point_.columns()};
  }

 private:
  /// Applies all filters along the columns, in blocks of columns that the fastest cache holds.
  void filterColumns(ColumnSpan span) {
    constexpr int kBlock = 128;
    for (ColumnSpan block{span.begin, 0}; block.begin < span.end; block.begin = block.end) {
      block.end = std::min(block.begin + kBlock, span.end);
      for (ColumnFilter* filter : {&smooth_, &edges_, &points_}) filterColumns(*filter, block);
      for (ColumnFilter& filter : blurs_) filterColumns(filter, block);
    }
  }
  void filterColumns(ColumnFilter& filter, ColumnSpan block) {
    filter.kernel.alongColumns(window_, filter.plane, block, filter.row.columns());
  }

  void blurRows(ColumnSpan span) {
    for (MarginedRow& row : color_) std::fill(row.columns() + span.begin, row.columns() + span.end, 0.0);
    for (std::size_t i = 0; i < blurs_.size(); ++i) {
      blurs_[i].kernel.alongRow(blurs_[i].row.columns(), span, across_.columns());
      addScaled(across_.columns(), weights_[i], span, color_[blurs_[i].plane].columns());
    }
    toHuntLab({color_[kY].columns(), color_[kCx].columns(), color_[kCz].columns()}, span);
  }

  /// Computes the strengths of edges and points. Each strength is the length of a gradient, whose components are
  /// filter responses along x and along y. Each response is smoothed in the other direction.
  void findFeatures(ColumnSpan span) {
    // Luminance is (Y + 16) / 116. The 16 cancels, because the weights of a profile sum to 0.
    constexpr double kScale = 116;
    for (const auto& [profile, length] : {std::pair(&edges_, &edge_), std::pair(&points_, &point_)}) {
      profile->kernel.alongRow(smooth_.row.columns(), span, length->columns());
      smooth_.kernel.alongRow(profile->row.columns(), span, across_.columns());
      toLengths(length->columns(), across_.columns(), kScale, span);
    }
  }

  RowWindow window_;
  const MarginedRow empty_{window_.width(), window_.radius()};
  const FeatureKernels features_;
  ColumnFilter smooth_{kY, features_.smooth, empty_}, edges_{kY, features_.edge, empty_},
      points_{kY, features_.point, empty_};
  std::vector<ColumnFilter> blurs_;
  std::vector<double> weights_;  ///< of the blurs
  MarginedRow across_ = empty_, edge_ = empty_, point_ = empty_;
  std::array<MarginedRow, kPlanes> color_{empty_, empty_, empty_};
};

template <typename Sample>
FlipMap flipOf(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b, double pixelsPerDegree) {
  POINSOT_EXPECT(a.size == b.size && !a.pixels.empty() && pixelsPerDegree > 0);
  const auto width = static_cast<std::size_t>(a.size.width);
  FlipMap map{a.size, std::vector<double>(width * static_cast<std::size_t>(a.size.height))};
  if (a.pixels == b.pixels) return map;
  AffectedSpans affected(a, b, flipRadius(pixelsPerDegree));
  PerceivedRows rowsA(a, pixelsPerDegree), rowsB(b, pixelsPerDegree);
  double* errors = map.error.data();
  for (int y = 0; y < a.size.height; ++y, errors += width) {
    const std::vector<ColumnSpan>& spans = affected.row(y);
    if (spans.empty()) continue;
    rowsA.moveTo(y, spans);
    rowsB.moveTo(y, spans);
    for (const ColumnSpan& span : spans) flipErrors(rowsA.row(), rowsB.row(), span, errors);
  }
  return map;
}

/// Quantiles weighted by value. at(share) returns the smallest value at which the running sum of the sorted values
/// exceeds `share` times the total. Only the values near a quantile are sorted: bins divide the values by size.
class WeightedQuantiles {
 public:
  /// @param values  at least one; none is 0, because zeros have no weight
  explicit WeightedQuantiles(std::vector<double> values) : values_(std::move(values)) {
    const auto [least, most] = std::ranges::minmax(values_);
    least_ = least;
    binsPerUnit_ = most > least ? kBins / (most - least) : 0;
    for (const double value : values_) bins_[binOf(value)] += value;
    total_ = std::accumulate(bins_.begin(), bins_.end(), 0.0);
  }

  double at(double share) const {
    double sum = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      if (sum + bins_[bin] > share * total_) return within(bin, sum, share * total_);
      sum += bins_[bin];
    }
    return 0;
  }

 private:
  static constexpr std::size_t kBins = 1024;

  std::size_t binOf(double value) const {
    return std::min(static_cast<std::size_t>((value - least_) * binsPerUnit_), kBins - 1);
  }

  double within(std::size_t bin, double sum, double wanted) const {
    core::checkInterruption();
    std::vector<double> sorted;
    std::ranges::copy_if(values_, std::back_inserter(sorted), [&](double v) { return binOf(v) == bin; });
    std::ranges::sort(sorted);
    for (const double value : sorted)
      if ((sum += value) > wanted) return value;
    return sorted.back();
  }

  std::vector<double> values_;
  std::array<double, kBins> bins_{};  ///< sum of the values in each bin
  double least_ = 0, binsPerUnit_ = 0, total_ = 0;
};

std::vector<double> nonzero(const std::vector<double>& values) {
  std::vector<double> found;
  std::ranges::copy_if(values, std::back_inserter(found), [](double value) { return value != 0; });
  return found;
}

}  // namespace

double FlipMap::mean() const {
  return std::accumulate(error.begin(), error.end(), 0.0) / static_cast<double>(error.size());
}

double FlipMap::max() const { return *std::max_element(error.begin(), error.end()); }

FlipFigures figuresOf(const FlipMap& map, std::optional<std::int64_t> pixels) {
  std::vector<double> errors = nonzero(map.error);
  if (errors.empty()) return {};
  const double counted = static_cast<double>(pixels && *pixels > 0 ? *pixels : std::ssize(map.error));
  const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / counted;
  const auto [least, most] = std::ranges::minmax(errors);
  const double min = errors.size() == map.error.size() ? least : 0;
  const WeightedQuantiles quantiles(std::move(errors));
  return {mean, min, quantiles.at(0.25), quantiles.at(0.5), quantiles.at(0.75), most};
}

FlipMap flip(const image::Image& a, const image::Image& b, double pixelsPerDegree) {
  return flipOf(a, b, pixelsPerDegree);
}

FlipMap flip(const image::DeepImage& a, const image::DeepImage& b, double pixelsPerDegree) {
  return flipOf(a, b, pixelsPerDegree);
}

}  // namespace poinsot::compare
