// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::core {

/// What a frame's time is spent on, in the order in which a frame goes through them.
enum class Step {
  kSimulate,  ///< states of the motion
  kCompose,   ///< the draw list of them
  kDraw,      ///< outlines and the passes over solids
  kResolve,   ///< the composite pass
  kRead,      ///< pixels from the back end
  kText,      ///< type, areas and strokes
  kConvert,   ///< RGB to the encoder's pixels
  kEncode,    ///< the encoder, or PNG compression, or a figure
  kWrite,     ///< files
};
inline constexpr std::size_t kSteps = 9;

/// "simulate"
const char* nameOf(Step step);

/// Seconds by step.
class StepTimes {
 public:
  double& operator[](Step step) { return seconds_[static_cast<std::size_t>(step)]; }
  double operator[](Step step) const { return seconds_[static_cast<std::size_t>(step)]; }
  StepTimes& operator+=(const StepTimes& other);
  StepTimes& operator-=(const StepTimes& other);
  /// Of these and those between them.
  double sum_s(Step first = Step::kSimulate, Step last = Step::kWrite) const;

 private:
  std::array<double, kSteps> seconds_{};
};

/// CPU seconds of this process so far, all its threads together.
double processCpu_s();
/// CLOCK_MONOTONIC: the same in all processes.
std::int64_t monotonic_ns();

/// A stretch of time on that clock, for a trace.
struct Span {
  std::string name;
  std::int64_t begin_ns = 0, end_ns = 0;
  std::optional<std::int64_t> frame = {};  ///< of which it is; none of a segment's end
};

/// What steps have cost, each without the steps inside it; while a trace is wanted also when they were. Of one
/// thread.
class StepLedger {
 public:
  const StepTimes& times() const { return times_; }
  void add(Step step, double seconds) { times_[step] += seconds; }

  /// From now on spans are kept. Who asks for them takes them often: they need memory.
  void trace() { traces_ = true; }
  /// What the next spans are of.
  void setFrame(std::optional<std::int64_t> frame) { frame_ = frame; }
  /// A span of no step. Nothing unless traced.
  void add(Span span);
  std::vector<Span> takeSpans();

 private:
  friend class StepScope;

  StepTimes times_;
  class StepScope* innermost_ = nullptr;
  bool traces_ = false;
  std::optional<std::int64_t> frame_;
  std::vector<Span> spans_;
};

/// Enters the time until its end into a ledger; without a ledger it does nothing. A step inside another is taken
/// off that one.
class StepScope {
 public:
  StepScope(StepLedger* ledger, Step step);
  ~StepScope();
  StepScope(const StepScope&) = delete;
  StepScope& operator=(const StepScope&) = delete;

 private:
  StepLedger* ledger_;
  Step step_;
  StepScope* outer_ = nullptr;
  double inner_s_ = 0;  // of the steps inside
  double begin_s_ = 0;
  std::int64_t begin_ns_ = 0;
};

}  // namespace poinsot::core
