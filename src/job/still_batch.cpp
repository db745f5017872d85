// SPDX-License-Identifier: Apache-2.0
#include "job/still_batch.h"

#include <algorithm>
#include <memory>

#include "core/expect.h"

namespace poinsot::job {
namespace {

/// Batch of renders, with several running at a time. Has only one thread, because it forks the workers.
class Batch {
 public:
  Batch(std::vector<RenderRequest> requests, const StillListener& listener)
      : requests_(std::move(requests)), listener_(listener), made_(requests_.size()) {}
  ~Batch() {
    for (const Running& each : running_) each.job->askToStop();
  }
  Batch(const Batch&) = delete;

  std::vector<MadeStill> make(std::size_t jobs) {
    for (std::size_t next = 0; next < requests_.size() || !running_.empty();) {
      while (next < requests_.size() && running_.size() < jobs) begin(next++);
      if (!running_.empty()) await();
    }
    return std::move(made_);
  }

 private:
  struct Running {
    std::size_t index;
    std::unique_ptr<RenderJob> job;
  };

  void begin(std::size_t index) {
    attempt(index, [&] {
      auto job =
          std::make_unique<RenderJob>(std::move(requests_[index]), [](std::int64_t, std::int64_t, double) {});
      job->begin();
      running_.push_back({index, std::move(job)});
    });
  }

  void await() {
    std::vector<const RenderJob*> jobs;
    for (const Running& each : running_) jobs.push_back(each.job.get());
    awaitReports(jobs);
    std::erase_if(running_, [&](const Running& each) {
      const bool well = attempt(each.index, [&] {
        each.job->takeReports();
        if (!each.job->isMaking()) made_[each.index].summary = each.job->end();
      });
      if (well && !each.job->isMaking()) listener_(each.index, std::nullopt);
      return !well || !each.job->isMaking();
    });
  }

  /// Runs `work`. If it throws an error, records and reports the error and returns false.
  template <typename Work>
  bool attempt(std::size_t index, const Work& work) {
    try {
      work();
      return true;
    } catch (const core::Error& error) {
      made_[index].failure = error;
      listener_(index, error);
      return false;
    }
  }

  std::vector<RenderRequest> requests_;
  const StillListener& listener_;
  std::vector<MadeStill> made_;
  std::vector<Running> running_;
};

}  // namespace

std::vector<MadeStill> makeStills(std::vector<RenderRequest> requests, int jobs, const StillListener& listener) {
  for (const RenderRequest& request : requests) POINSOT_EXPECT(request.frames.count() == 1);
  return Batch(std::move(requests), listener).make(static_cast<std::size_t>(std::max(jobs, 1)));
}

}  // namespace poinsot::job
