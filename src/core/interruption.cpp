// SPDX-License-Identifier: Apache-2.0
#include "core/interruption.h"

#include <utility>

#include "core/step_times.h"

namespace poinsot::core {
namespace {

constexpr std::int64_t kPeriod_ns = 50'000'000;  // 50 ms, a delay that nobody notices

thread_local InterruptionCheck* innermost = nullptr;

}  // namespace

InterruptionCheck::InterruptionCheck(std::function<void()> check)
    : check_(std::move(check)), due_ns_(monotonic_ns() + kPeriod_ns), outer_(std::exchange(innermost, this)) {}

InterruptionCheck::~InterruptionCheck() { innermost = outer_; }

void checkInterruption() {
  InterruptionCheck* const check = innermost;
  if (check == nullptr) return;
  const std::int64_t now_ns = monotonic_ns();
  if (now_ns < check->due_ns_) return;
  check->due_ns_ = now_ns + kPeriod_ns;
  check->check_();
}

}  // namespace poinsot::core
