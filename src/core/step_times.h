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

/// Step of making a frame whose time is measured; frames go through the steps in this order.
enum class Step {
  kSimulate,
  kCompose,  ///< builds the draw list
  kDraw,     ///< draws outlines, and the passes over solids
  kResolve,  ///< draws the composite pass
  kRead,     ///< reads pixels back from OpenGL
  kText,     ///< draws type, areas and strokes
  kConvert,  ///< converts RGB to the encoder's pixels
  kEncode,   ///< encodes video, PNG or a figure
  kWrite,
};
inline constexpr std::size_t kSteps = 9;

const char* nameOf(Step step);

/// Seconds spent in each step.
class StepTimes {
 public:
  double& operator[](Step step) { return seconds_[static_cast<std::size_t>(step)]; }
  double operator[](Step step) const { return seconds_[static_cast<std::size_t>(step)]; }
  StepTimes& operator+=(const StepTimes& other);
  StepTimes& operator-=(const StepTimes& other);
  /// Returns the sum over the steps from `first` to `last`, both included.
  double sum_s(Step first = Step::kSimulate, Step last = Step::kWrite) const;

 private:
  std::array<double, kSteps> seconds_{};
};

/// Returns the CPU seconds of this process so far, over all its threads.
double processCpu_s();
/// Returns the time of CLOCK_MONOTONIC, which all processes share.
std::int64_t monotonic_ns();

/// Interval on the clock of monotonic_ns(), for a trace.
struct Span {
  std::string name;
  std::int64_t begin_ns = 0, end_ns = 0;
  std::optional<std::int64_t> frame = {};  ///< frame number; nullopt at the end of a segment
};

/// Ledger of the time that one thread spends in each step, without nested steps. With trace(), also keeps spans.
class StepLedger {
 public:
  const StepTimes& times() const { return times_; }
  void add(Step step, double seconds) { times_[step] += seconds; }

  /// Records spans from now on. Call takeSpans() often, because spans need memory.
  void trace() { traces_ = true; }
  void setFrame(std::optional<std::int64_t> frame) { frame_ = frame; }
  /// Records a span; does nothing without trace().
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

/// Scope whose duration is added to a step of a ledger. Time in a nested scope counts for the nested step only.
/// Without a ledger (null), does nothing.
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
  double inner_s_ = 0;  // time of nested steps
  double begin_s_ = 0;
  std::int64_t begin_ns_ = 0;
};

}  // namespace poinsot::core
