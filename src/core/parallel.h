// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace poinsot::core {

/// Calls work(0), ..., work(count - 1) on at most `jobs` threads. After an exception, no further call begins.
/// Rethrows the exception of the lowest index, so the result does not depend on the number of threads. Polls the
/// caller's core::InterruptionCheck meanwhile. An interruption also ends calls of `work` that use
/// core::checkInterruption().
void forEachIndex(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace poinsot::core
