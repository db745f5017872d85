// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "core/abi.h"

/// Lets the caller of a long computation end it.
namespace poinsot::core {

/// Calls the InterruptionCheck of this thread, if there is one and 50 ms have passed since its last call. Costs
/// some 30 ns, so a loop may call it in every pass.
/// @throws whatever the check throws.
void checkInterruption();

/// Holds the check of the thread that makes it; the check before comes back when this one ends.
class InterruptionCheck {
 public:
  /// @param check  throws if the computation has to end.
  explicit InterruptionCheck(std::function<void()> check);
  ~InterruptionCheck();
  InterruptionCheck(const InterruptionCheck&) = delete;
  InterruptionCheck& operator=(const InterruptionCheck&) = delete;

 private:
  friend void checkInterruption();

  std::function<void()> check_;
  std::int64_t due_ns_;
  InterruptionCheck* outer_;
};

}  // namespace poinsot::core
