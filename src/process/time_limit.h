// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace poinsot::process {

/// Ends this process after so many seconds by the clock, as a limit that was exceeded. Where interrupts are
/// watched throwIfInterrupted() throws core::Error(kLimit) then, so that what is complete is kept; where nothing
/// looks for them, or for 5 s more, the process says why and ends with `exitCode` at once.
/// @pre seconds > 0.
void limitTime(std::int64_t seconds, int exitCode);

}  // namespace poinsot::process
