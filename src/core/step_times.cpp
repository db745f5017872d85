// SPDX-License-Identifier: Apache-2.0
#include "core/step_times.h"

#include <time.h>

#include <algorithm>
#include <new>
#include <utility>

namespace poinsot::core {
namespace {

struct StepFacts {
  const char* name;
  clockid_t clock;
};

// Clocks of the steps. The clock of process CPU time includes llvmpipe's own threads. Simulation uses the wall
// clock, because reading it takes only 25 ns. Reading CPU time takes 500 ns, longer than computing a state, and a
// path has thousands of states.
constexpr std::array<StepFacts, kSteps> kFacts{{{"simulate", CLOCK_MONOTONIC},
                                                {"compose", CLOCK_THREAD_CPUTIME_ID},
                                                {"draw", CLOCK_PROCESS_CPUTIME_ID},
                                                {"resolve", CLOCK_PROCESS_CPUTIME_ID},
                                                {"read", CLOCK_PROCESS_CPUTIME_ID},
                                                {"text", CLOCK_THREAD_CPUTIME_ID},
                                                {"convert", CLOCK_THREAD_CPUTIME_ID},
                                                {"encode", CLOCK_THREAD_CPUTIME_ID},
                                                {"write", CLOCK_THREAD_CPUTIME_ID}}};

const StepFacts& factsOf(Step step) { return kFacts[static_cast<std::size_t>(step)]; }

std::int64_t now_ns(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

double now_s(clockid_t clock) { return 1e-9 * static_cast<double>(now_ns(clock)); }

}  // namespace

const char* nameOf(Step step) { return factsOf(step).name; }

double processCpu_s() { return now_s(CLOCK_PROCESS_CPUTIME_ID); }
std::int64_t monotonic_ns() { return now_ns(CLOCK_MONOTONIC); }

StepTimes& StepTimes::operator+=(const StepTimes& other) {
  for (std::size_t i = 0; i < kSteps; ++i) seconds_[i] += other.seconds_[i];
  return *this;
}

StepTimes& StepTimes::operator-=(const StepTimes& other) {
  for (std::size_t i = 0; i < kSteps; ++i) seconds_[i] -= other.seconds_[i];
  return *this;
}

double StepTimes::sum_s(Step first, Step last) const {
  double sum = 0;
  for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last); ++i) sum += seconds_[i];
  return sum;
}

// Merges repeated spans of a step into one span. For example, composing a path computes many states in between.
// The merged span begins with the first span and lasts as long as all of them together, so it stays within the
// outer step.
void StepLedger::add(Span span) {
  if (!traces_) return;
  if (!spans_.empty() && spans_.back().name == span.name && spans_.back().frame == span.frame)
    spans_.back().end_ns += span.end_ns - span.begin_ns;
  else
    spans_.push_back(std::move(span));
}

std::vector<Span> StepLedger::takeSpans() { return std::exchange(spans_, {}); }

StepScope::StepScope(StepLedger* ledger, Step step) : ledger_(ledger), step_(step) {
  if (ledger_ == nullptr) return;
  outer_ = std::exchange(ledger_->innermost_, this);
  if (ledger_->traces_) begin_ns_ = monotonic_ns();
  begin_s_ = now_s(factsOf(step_).clock);
}

StepScope::~StepScope() {
  if (ledger_ == nullptr) return;
  const double spent_s = now_s(factsOf(step_).clock) - begin_s_;
  // The difference is negative if a nested step waited for a CPU and was measured with the wall clock.
  ledger_->add(step_, std::max(spent_s - inner_s_, 0.0));
  if (outer_ != nullptr) outer_->inner_s_ += spent_s;
  ledger_->innermost_ = outer_;
  if (!ledger_->traces_) return;
  try {
    ledger_->add({nameOf(step_), begin_ns_, monotonic_ns(), ledger_->frame_});
  } catch (const std::bad_alloc&) {
    // Drops the span: an incomplete trace is better than an exception from a destructor.
  }
}

}  // namespace poinsot::core
