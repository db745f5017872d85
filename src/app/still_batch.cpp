// SPDX-License-Identifier: Apache-2.0
#include "app/still_batch.h"

#include <mutex>

#include "app/parallel.h"
#include "core/expect.h"

namespace poinsot::app {
namespace {

std::optional<core::Error> failureOf(const RenderRequest& request) {
  try {
    RenderJob(request, [](std::int64_t, std::int64_t, double) {}).run();
    return std::nullopt;
  } catch (const core::Error& error) {
    return error;
  }
}

}  // namespace

// A worker dies with the thread that started it, so each is waited for by that thread.
std::vector<std::optional<core::Error>> makeStills(const std::vector<RenderRequest>& requests, int jobs,
                                                   const StillListener& listener) {
  for (const RenderRequest& request : requests) POINSOT_EXPECT(request.frames.count() == 1);
  std::vector<std::optional<core::Error>> failures(requests.size());
  std::mutex mutex;
  // Each thread waits for one worker process at a time and draws nothing itself.
  forEachIndex(requests.size(), jobs, [&](std::size_t i) {
    auto failure = failureOf(requests[i]);
    const std::lock_guard lock(mutex);
    failures[i] = std::move(failure);
    listener(i, failures[i]);
  });
  return failures;
}

}  // namespace poinsot::app
