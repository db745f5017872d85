// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_convention.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "reference/grade.h"
#include "reference/grade_shift.h"
#include "reference/grade_turn.h"

namespace poinsot::reference {
namespace {

constexpr std::size_t kFewestSampleRows = 3;  // fewer rows may fit by chance
constexpr std::size_t kSampleRows = 64;
constexpr std::size_t kMostReadings = 3;
constexpr double kWrong = 1e-3;             // rad or relative; larger than the rounding errors of a log
constexpr double kMostLeft = 0.05;          // largest fraction of a misfit that may remain
constexpr double kUnrelated = 0.5;          // rad or relative; largest misfit that may remain
constexpr double kWorse = 2;                // largest factor by which a misfit may grow
const double kEqualScores = std::log(10.);  // if scores differ by less, the simpler reading is chosen

bool isWrong(const std::optional<double>& misfit) { return misfit && *misfit > kWrong; }
bool isWrong(const Misfit& misfit) { return isWrong(misfit.attitude) || isWrong(misfit.omega); }

bool helps(const std::optional<double>& after, const std::optional<double>& before) {
  return isWrong(before) && after && *after < std::min(kMostLeft * *before, kUnrelated);
}

bool harms(const std::optional<double>& after, const std::optional<double>& before) {
  return before && !(after && *after <= std::max(kWorse * *before, kMostLeft * kWrong));
}

bool isBetter(const Misfit& after, const Misfit& before) {
  if (harms(after.attitude, before.attitude) || harms(after.omega, before.omega)) return false;
  return helps(after.attitude, before.attitude) || helps(after.omega, before.omega);
}

/// Returns whether every misfit that was too large has been reduced.
bool explains(const Misfit& after, const Misfit& before) {
  return isBetter(after, before) && (!isWrong(before.attitude) || helps(after.attitude, before.attitude)) &&
         (!isWrong(before.omega) || helps(after.omega, before.omega));
}

/// Returns a sample of the log: rows with finite values, in the order of time, evenly distributed over the log.
LogSample sampleOf(const KnownMotion& motion, const TrajectoryTable& theirs) {
  std::vector<std::size_t> rows(theirs.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::erase_if(rows, [&](std::size_t row) { return !isFinite(loggedState(theirs, row)); });
  std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return theirs.t_s(row); });
  LogSample sample;
  const std::size_t count = std::min(rows.size(), kSampleRows);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = rows[count == 1 ? 0 : i * (rows.size() - 1) / (count - 1)];
    sample.theirs.push_back(loggedState(theirs, row));
    sample.ours.push_back(motion.at(theirs.t_s(row)));
  }
  return sample;
}

struct Finding {
  std::vector<Reading> readings;
  LogSample sample;
};

class ConventionSearch {
 public:
  ConventionSearch(KnownMotion& motion, const MotionMaker& maker, const physics::TimeSpan& span, LogSample sample)
      : motion_(motion), asWritten_(std::move(sample)), usual_(namedHypotheses(motion.motion())) {
    usual_.push_back(shiftHypothesis(motion, maker, span));
    for (Hypothesis& hypothesis : turnHypotheses()) usual_.push_back(std::move(hypothesis));
  }

  std::vector<Reading> readings() const;

 private:
  std::optional<Finding> oneMore(const Finding& found, const Hypothesis& hypothesis) const;
  std::vector<Finding> singles(const Finding& found, std::span<const Hypothesis> hypotheses) const;
  std::vector<Finding> pairs(const Finding& found) const;
  std::optional<Finding> better(const Finding& found) const;

  const KnownMotion& motion_;
  LogSample asWritten_;
  std::vector<Hypothesis> usual_;  // ordered by simplicity, simplest first
  const std::vector<Hypothesis> exchanges_ = exchangeHypotheses(), twoTurns_{twoTurnsHypothesis()};
};

std::optional<Finding> ConventionSearch::oneMore(const Finding& found, const Hypothesis& hypothesis) const {
  if (std::ranges::find(found.readings, hypothesis.aspect, &Reading::aspect) != found.readings.end())
    return std::nullopt;
  auto reading = hypothesis.reading(found.sample);
  if (!reading) return std::nullopt;
  std::vector<Reading> readings = found.readings;
  readings.push_back(std::move(*reading));
  std::ranges::stable_sort(readings, {}, &Reading::aspect);
  auto sample = readAs(asWritten_, readings, motion_);
  return sample ? std::optional(Finding{std::move(readings), std::move(*sample)}) : std::nullopt;
}

std::vector<Finding> ConventionSearch::singles(const Finding& found,
                                               std::span<const Hypothesis> hypotheses) const {
  std::vector<Finding> all;
  for (const Hypothesis& hypothesis : hypotheses)
    if (auto more = oneMore(found, hypothesis)) all.push_back(std::move(*more));
  return all;
}

std::vector<Finding> ConventionSearch::pairs(const Finding& found) const {
  std::vector<Finding> all;
  const auto add = [&](const Hypothesis& hypothesis, std::span<const Hypothesis> others) {
    const auto first = oneMore(found, hypothesis);
    if (!first) return;
    for (Finding& second : singles(*first, others)) all.push_back(std::move(second));
  };
  for (std::size_t i = 0; i < usual_.size(); ++i) add(usual_[i], std::span(usual_).subspan(i + 1));
  for (const Hypothesis& exchange : exchanges_) add(exchange, usual_);
  return all;
}

/// Returns the finding with the best score; if several are about as good, the first of them. Returns nullopt if
/// none improves the fit.
std::optional<Finding> bestOf(std::vector<Finding> findings, const Misfit& before) {
  std::erase_if(findings, [&](const Finding& finding) { return !isBetter(misfitOf(finding.sample), before); });
  double least = std::numeric_limits<double>::infinity();
  for (const Finding& finding : findings) least = std::min(least, scoreOf(finding.sample));
  for (Finding& finding : findings)
    if (scoreOf(finding.sample) <= least + kEqualScores) return std::move(finding);
  return std::nullopt;
}

/// Returns the simplest finding that reduces every misfit, or else the simplest that reduces one misfit.
std::optional<Finding> ConventionSearch::better(const Finding& found) const {
  const Misfit before = misfitOf(found.sample);
  std::optional<Finding> partly;
  for (int stage = 0; stage < 3; ++stage) {
    auto best = bestOf(stage == 0   ? singles(found, usual_)
                       : stage == 1 ? pairs(found)
                                    : singles(found, twoTurns_),
                       before);
    if (best && explains(misfitOf(best->sample), before)) return best;
    if (!partly) partly = std::move(best);
  }
  return partly;
}

std::vector<Reading> ConventionSearch::readings() const {
  Finding found{{}, asWritten_};
  while (found.readings.size() < kMostReadings && isWrong(misfitOf(found.sample))) {
    auto more = better(found);
    if (!more) break;
    found = std::move(*more);
  }
  return found.readings;
}

}  // namespace

std::vector<Reading> fittingReadings(KnownMotion& motion, const MotionMaker& maker,
                                     const TrajectoryTable& theirs) {
  LogSample sample = sampleOf(motion, theirs);
  if (sample.theirs.size() < kFewestSampleRows) return {};
  return ConventionSearch(motion, maker, spanOf(theirs), std::move(sample)).readings();
}

}  // namespace poinsot::reference
