// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "core/abi.h"

namespace poinsot::core {

/// Calls the InterruptionCheck of this thread, unless its last call was less than 50 ms ago. Costs about 30 ns, so
/// loops may call this function in every pass.
/// @throws the exception of the check
void checkInterruption();

/// Scope that sets the interruption check of the current thread. The destructor restores the previous check.
class InterruptionCheck {
 public:
  /// @param check  function that throws an exception to stop the computation
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
