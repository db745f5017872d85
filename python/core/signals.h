// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>

#include "core/interruption.h"

namespace poinsot::python {

/// How long a wait may be deaf to Ctrl-C.
inline constexpr std::chrono::milliseconds kPatience{50};

/// Notes which thread Python runs handlers of signals on. Call it with the GIL, once.
void rememberMainThread();

/// Runs the handlers of signals that arrived, as Python does between two of its instructions; nothing on other
/// threads than the main one. Call it without the GIL.
/// @throws pybind11::error_already_set with what a handler raises, such as KeyboardInterrupt.
void checkSignals();

/// Releases the GIL, and lets Ctrl-C end computations that call core::checkInterruption().
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

/// Keeps daemon threads that compute from taking the GIL back: Python would end them by an exception that no
/// destructor lets through (python/cpython#87135), and the process with them. Call it at the process's end,
/// without the GIL.
void leaveThreadsAlone();

}  // namespace poinsot::python
