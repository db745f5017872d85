// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_drift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/expect.h"

namespace poinsot::reference {
namespace {

constexpr std::size_t kFewestRows = 16;    // two rows per group
constexpr std::size_t kFewestGroups = 8;   // needed to fit the four parameters of Model
constexpr std::size_t kMostGroups = 125;   // limited, because the cost of the fits is quadratic
constexpr std::size_t kRowsPerGroup = 8;   // includes the peaks of an oscillating error
constexpr std::size_t kFewestGrowing = 4;  // groups needed to fit the growth
constexpr double kLeastGrowth = 4;         // smallest growth that counts as a drift, as a factor
constexpr double kMostUnexplained = 0.5;   // largest unexplained fraction of the scatter, for a drift
constexpr double kWorthAStart = 0.5;       // largest ratio of residuals: later start to start at row 0
constexpr double kCloseFit = 0.1;          // rms of ln e; a closer fit is clear even with little scatter
constexpr double kMostUnclear = 0.1;       // largest unexplained fraction of the scatter for a clear law of growth

/// Group of consecutive rows, represented by the largest error.
struct Group {
  double start;     ///< |t - t0| of the last row of the previous group
  double time;      ///< |t - t0| of the row with the largest error
  double logError;  ///< ln of the largest error, but at least ln kRoundingError
  std::size_t lastRow;
};

/// Least-squares fit of a line, y = intercept + slope x.
struct Line {
  double intercept = 0, slope = 0;
  double residual = 0;  ///< sum of the squared residuals
  double scatter = 0;   ///< sum of the squared deviations from the mean
  std::size_t count = 0;
};

class LineFit {
 public:
  void add(double x, double y) {
    // Welford's method, which avoids cancellation in the sums of squares.
    ++n_;
    const double dx = x - meanX_, dy = y - meanY_, n = static_cast<double>(n_);
    meanX_ += dx / n;
    meanY_ += dy / n;
    xx_ += dx * (x - meanX_);
    yy_ += dy * (y - meanY_);
    xy_ += dx * (y - meanY_);
  }
  Line line() const {
    const double slope = xx_ > 0 ? xy_ / xx_ : 0;
    return {meanY_ - slope * meanX_, slope, std::max(0.0, yy_ - slope * xy_), yy_, n_};
  }

 private:
  std::size_t n_ = 0;
  double meanX_ = 0, meanY_ = 0, xx_ = 0, yy_ = 0, xy_ = 0;
};

/// Model of an error that is constant before the group `first`, and then grows as a power of time.
struct Model {
  std::size_t first = 0;
  double residual = std::numeric_limits<double>::infinity();
  Line before;
  Line after;
};

std::vector<Group> groupsOf(std::span<const double> t_s, std::span<const double> errors) {
  const std::size_t count = std::clamp(errors.size() / kRowsPerGroup, kFewestGroups, kMostGroups);
  std::vector<Group> groups;
  for (std::size_t g = 0; g < count; ++g) {
    const std::size_t from = g * errors.size() / count, to = (g + 1) * errors.size() / count;
    const auto largest =
        static_cast<std::size_t>(std::max_element(errors.begin() + static_cast<std::ptrdiff_t>(from),
                                                  errors.begin() + static_cast<std::ptrdiff_t>(to)) -
                                 errors.begin());
    groups.push_back({std::abs(t_s[from > 0 ? from - 1 : 0] - t_s[0]), std::abs(t_s[largest] - t_s[0]),
                      std::log(std::max(errors[largest], kRoundingError)), to - 1});
  }
  return groups;
}

Line constant(std::span<const Group> groups) {
  LineFit fit;
  for (const Group& group : groups) fit.add(0, group.logError);
  return fit.line();
}

/// Fits a power of time: a line through ln e as a function of ln(|t - t0| - origin).
Line power(std::span<const Group> groups, double origin) {
  LineFit fit;
  for (const Group& group : groups)
    if (group.time > origin) fit.add(std::log(group.time - origin), group.logError);
  return fit.line();
}

Line exponential(std::span<const Group> groups) {
  LineFit fit;
  for (const Group& group : groups) fit.add(group.time, group.logError);
  return fit.line();
}

Model modelFrom(std::span<const Group> groups, std::size_t first) {
  const Line before = constant(groups.first(first)), after = power(groups.subspan(first), groups[first].start);
  return {first, before.residual + after.residual, before, after};
}

Model bestModel(std::span<const Group> groups) {
  const Model plain = modelFrom(groups, 0);
  Model best = plain;
  for (std::size_t first = 1; first + kFewestGrowing <= groups.size(); ++first) {
    const Model model = modelFrom(groups, first);
    if (model.residual < best.residual) best = model;
  }
  return best.residual < kWorthAStart * plain.residual ? best : plain;
}

bool grows(const Model& model, std::span<const Group> groups) {
  if (model.residual > kMostUnexplained * constant(groups).scatter) return false;
  const double level = model.first > 0 ? model.before.intercept : groups[0].logError;
  const double end =
      model.after.intercept + model.after.slope * std::log(groups.back().time - groups[model.first].start);
  return end - level > std::log(kLeastGrowth);
}

/// Returns the row at which the drift starts: the last row, up to the group model.first, whose error is not yet
/// larger than before (see findDrift()).
std::size_t startOf(const Model& model, std::span<const Group> groups, std::span<const double> errors) {
  if (model.first < 2) return 0;
  double level = 0;
  for (std::size_t g = 0; g + 1 < model.first; ++g) level = std::max(level, std::exp(groups[g].logError));
  std::size_t last = groups[model.first].lastRow;
  while (last > 0 && errors[last] > 2 * level) --last;
  return last;
}

void describeGrowth(Drift& drift, std::span<const Group> growing, double origin) {
  const Line line = power(growing, origin), rising = exponential(growing);
  const double unclear =
      std::max(kMostUnclear * line.scatter, kCloseFit * kCloseFit * static_cast<double>(line.count));
  if (rising.residual < 0.5 * line.residual && rising.residual <= unclear && rising.slope > 0) {
    drift.growth = Growth::kExponential;
    drift.rate = rising.slope;
  } else if (line.residual <= unclear) {
    drift.growth = Growth::kPower;
    drift.order = line.slope;
  }
}

std::size_t judgedRows(std::span<const double> errors) {
  return static_cast<std::size_t>(
      std::find_if(errors.begin(), errors.end(), [](double e) { return !(e < kLostError); }) - errors.begin());
}

}  // namespace

Drift findDrift(std::span<const double> t_s, std::span<const double> errors) {
  POINSOT_EXPECT(t_s.size() == errors.size());
  const std::size_t judged = judgedRows(errors);
  if (std::ranges::all_of(errors, [](double e) { return e <= kRoundingError; })) return {DriftKind::kRounding};
  if (judged < kFewestRows) {
    // There are too few rows for a fit. The drift starts after the last row whose error is within rounding.
    if (judged == errors.size()) return {DriftKind::kTooFewRows};
    std::size_t last = judged;
    while (last > 0 && errors[last] > kRoundingError) --last;
    return {DriftKind::kDrift, t_s[last]};
  }
  const auto groups = groupsOf(t_s.first(judged), errors.first(judged));
  const Model model = bestModel(groups);
  if (!grows(model, groups)) {
    if (judged == errors.size()) return {DriftKind::kLevel};
    return {DriftKind::kDrift, t_s[judged - 1]};  // constant, then above kLostError from one row to the next
  }
  const double from_s = t_s[startOf(model, groups, errors.first(judged))];
  Drift drift{DriftKind::kDrift, from_s};
  describeGrowth(drift, std::span(groups).subspan(model.first), std::abs(from_s - t_s[0]));
  return drift;
}

}  // namespace poinsot::reference
