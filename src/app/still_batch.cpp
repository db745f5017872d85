// SPDX-License-Identifier: Apache-2.0
#include "app/still_batch.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

#include "app/interrupt.h"
#include "core/expect.h"

namespace poinsot::app {
namespace {

/// What the threads share. Each waits for one worker process at a time and draws nothing itself.
class Batch {
 public:
  Batch(const std::vector<RenderRequest>& requests, const StillListener& listener)
      : requests_(requests), listener_(listener), failures_(requests.size()) {}

  void work() {
    for (std::size_t i = next_++; i < requests_.size() && !stopped_; i = next_++) {
      try {
        report(i, failureOf(requests_[i]));
      } catch (...) {  // an interruption, or the listener's: for whoever waits for the batch
        stop(std::current_exception());
      }
    }
  }

  std::vector<std::optional<core::Error>> result() {
    if (stopper_) std::rethrow_exception(stopper_);
    return std::move(failures_);
  }

 private:
  static std::optional<core::Error> failureOf(const RenderRequest& request) {
    try {
      RenderJob(request, [](std::int64_t, std::int64_t, double) {}).run();
      return std::nullopt;
    } catch (const core::Error& error) {
      return error;
    }
  }

  void report(std::size_t index, std::optional<core::Error> failure) {
    const std::lock_guard lock(mutex_);
    failures_[index] = std::move(failure);
    listener_(index, failures_[index]);
  }

  void stop(std::exception_ptr why) {
    const std::lock_guard lock(mutex_);
    if (!stopper_) stopper_ = std::move(why);
    stopped_ = true;
  }

  const std::vector<RenderRequest>& requests_;
  const StillListener& listener_;
  std::vector<std::optional<core::Error>> failures_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::exception_ptr stopper_;
  std::mutex mutex_;
};

}  // namespace

// A worker dies with the thread that started it, so a thread lives until its workers are done.
std::vector<std::optional<core::Error>> makeStills(const std::vector<RenderRequest>& requests, int jobs,
                                                   const StillListener& listener) {
  for (const RenderRequest& request : requests) POINSOT_EXPECT(request.frames.count() == 1);
  Batch batch(requests, listener);
  {
    std::vector<std::jthread> threads;
    const std::size_t count = std::min(requests.size(), static_cast<std::size_t>(jobs));
    for (std::size_t i = 0; i < count; ++i) threads.emplace_back([&batch] { batch.work(); });
  }
  return batch.result();
}

}  // namespace poinsot::app
