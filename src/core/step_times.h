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

/// Step in making a frame, with its time measured separately. A frame goes through the steps in this order.
enum class Step {
  kSimulate,
  kCompose,  ///< builds the draw list
  kDraw,     ///< draws outlines and solids
  kResolve,  ///< draws the composite pass
  kRead,     ///< reads pixels back from OpenGL
  kText,     ///< draws text, areas and strokes
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
  /// Returns the sum of the seconds of the steps from `first` to `last`, both included.
  double sum_s(Step first = Step::kSimulate, Step last = Step::kWrite) const;

 private:
  std::array<double, kSteps> seconds_{};
};

/// Returns the CPU time that this process has used so far, in s, summed over all its threads.
double processCpu_s();
/// Returns the time of CLOCK_MONOTONIC, which is the same in all processes.
std::int64_t monotonic_ns();

/// Time interval on the clock of monotonic_ns(), for a trace file.
struct Span {
  std::string name;
  std::int64_t begin_ns = 0, end_ns = 0;
  std::optional<std::int64_t> frame = {};  ///< frame number; nullopt for work after the last frame of a segment
};

/// Seconds that one thread spends in each step. A step's time excludes the steps nested in it. After trace(), the
/// ledger also records spans.
class StepLedger {
 public:
  const StepTimes& times() const { return times_; }
  void add(Step step, double seconds) { times_[step] += seconds; }

  /// Starts to record spans. Call takeSpans() often, because the recorded spans use memory.
  void trace() { traces_ = true; }
  void setFrame(std::optional<std::int64_t> frame) { frame_ = frame; }
  /// Records a span; does nothing before trace().
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

/// Scope that measures its own duration and adds it to a step of a ledger. The time of a nested scope counts only
/// for the nested step. If the ledger is null, measures nothing.
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
  double inner_s_ = 0;  // time spent in nested scopes
  double begin_s_ = 0;
  std::int64_t begin_ns_ = 0;
};

}  // namespace poinsot::core
