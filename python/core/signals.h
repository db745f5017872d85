// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>

#include "core/interruption.h"

namespace poinsot::python {

/// Longest time for which a wait ignores Ctrl-C.
inline constexpr std::chrono::milliseconds kPatience{50};

/// Records the thread on which Python runs signal handlers. Call it once, with the GIL.
void rememberMainThread();

/// Runs the handlers of signals that arrived, as Python does between two instructions. Does nothing on threads
/// other than the main one. Call it without the GIL.
/// @throws pybind11::error_already_set with the exception of a handler, such as KeyboardInterrupt.
void checkSignals();

/// Scope without the GIL, in which Ctrl-C ends computations that call core::checkInterruption().
class WithoutGil {
 public:
  WithoutGil() = default;
  ~WithoutGil();
  WithoutGil(const WithoutGil&) = delete;
  WithoutGil& operator=(const WithoutGil&) = delete;

 private:
  std::optional<pybind11::gil_scoped_release> others_{std::in_place};
  core::InterruptionCheck check_{checkSignals};
};

/// Keeps daemon threads that compute from taking the GIL back at the end of the process. Python would end them by
/// an exception that no destructor lets through (python/cpython#87135), which ends the process. Call it without
/// the GIL.
void leaveThreadsAlone();

}  // namespace poinsot::python
