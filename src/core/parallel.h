// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace poinsot::core {

/// Calls work(0), ..., work(count - 1) on at most `jobs` threads. After an exception no further call begins, and
/// the exception of the lowest index is rethrown, regardless of the number of threads. Meanwhile the caller's
/// core::InterruptionCheck is polled; an interruption also ends calls that use core::checkInterruption().
void forEachIndex(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace poinsot::core
