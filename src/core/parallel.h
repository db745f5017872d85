// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace poinsot::core {

/// Calls work(0), ..., work(count - 1), on `jobs` threads at most. Once one has thrown no other is begun, and of
/// those that threw the one with the lowest index is thrown on, whatever the number of threads. The caller's
/// core::InterruptionCheck is called meanwhile, and ends all of them where the work calls
/// core::checkInterruption().
void forEachIndex(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace poinsot::core
