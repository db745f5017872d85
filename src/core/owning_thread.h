// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>

namespace poinsot::core {

/// Value that is created, used and destroyed on one thread of its own, such as an OpenGL context. Other threads
/// queue work for that thread, which runs the work in order. The destructor drops work that has not begun.
template <class Value>
class OwningThread {
 public:
  explicit OwningThread(std::function<std::unique_ptr<Value>()> make)
      : thread_([this, make = std::move(make)](const std::stop_token& stop) { work(stop, make); }) {}
  OwningThread(const OwningThread&) = delete;
  OwningThread& operator=(const OwningThread&) = delete;

  /// Runs `work` on the owning thread and waits for its result. @throws the exception of `work`
  template <class Work>
  std::invoke_result_t<Work, Value&> with(Work work) {
    return begin(std::move(work)).get();
  }

  /// Queues `work` for the owning thread and returns its future. The work must own the data that it uses, because
  /// the caller need not wait.
  template <class Work>
  std::future<std::invoke_result_t<Work, Value&>> begin(Work work) {
    std::packaged_task<std::invoke_result_t<Work, Value&>(Value&)> task(std::move(work));
    auto result = task.get_future();
    {
      const std::scoped_lock lock(mutex_);
      jobs_.emplace_back([task = std::move(task)](Value& value) mutable { task(value); });
    }
    waiting_.notify_one();
    return result;
  }

 private:
  using Job = std::packaged_task<void(Value&)>;

  void work(const std::stop_token& stop, const std::function<std::unique_ptr<Value>()>& make) {
    const std::unique_ptr<Value> value = make();
    while (true) {
      std::unique_lock lock(mutex_);
      if (!waiting_.wait(lock, stop, [&] { return !jobs_.empty(); })) break;
      Job job = std::move(jobs_.front());
      jobs_.pop_front();
      lock.unlock();
      job(*value);
    }
  }

  std::mutex mutex_;
  std::condition_variable_any waiting_;
  std::deque<Job> jobs_;
  std::jthread thread_;  // declared last, because the thread uses the members above
};

}  // namespace poinsot::core
