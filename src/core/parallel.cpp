// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <vector>

#include "core/interruption.h"

namespace poinsot::core {
namespace {

/// Exception that ends the work of a helper thread after an interruption of its caller.
class Abandoned : public std::exception {};

void awaitAll(const std::vector<std::future<void>>& helpers) {
  constexpr std::chrono::milliseconds kPatience{50};
  for (const std::future<void>& helper : helpers)
    while (helper.wait_for(kPatience) != std::future_status::ready) checkInterruption();
}

}  // namespace

void forEachIndex(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  const auto most = std::min(count, static_cast<std::size_t>(std::max(jobs, 1)));
  if (most <= 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::vector<std::exception_ptr> failures(count);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false, abandoned = false;
  const auto run = [&] {
    const InterruptionCheck check([&] {
      if (abandoned) throw Abandoned();
    });
    // Takes indices in order and completes each. If an index fails, all lower indices are completed as well.
    for (std::size_t i; !failed && (i = next++) < count;) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
        failed = true;
      }
    }
  };
  std::vector<std::future<void>> helpers;  // futures whose destructors wait for the threads
  try {
    while (helpers.size() < most) helpers.push_back(std::async(std::launch::async, run));
    awaitAll(helpers);
  } catch (...) {
    failed = abandoned = true;
    throw;
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace poinsot::core
