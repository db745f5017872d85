// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "core/file_handle.h"

namespace poinsot::preview {

/// Where connections wait until the head of their request is there. One thread watches all of them, so that a
/// connection that sends slowly, or nothing, takes the place of nobody: it is closed after kPatience, and the
/// oldest is closed where more than kMostWaiting wait.
class Anteroom {
 public:
  static constexpr std::chrono::seconds kPatience{5};
  static constexpr std::size_t kMostWaiting = 256;
  static constexpr std::size_t kLongestHead = 32 << 10;  ///< bytes of a request before its body

  /// @param admit  takes a connection whose head can be read without waiting; it owns the socket from then on.
  ///               Called by the watching thread.
  explicit Anteroom(std::function<void(core::FileHandle)> admit);
  /// Closes all that still wait.
  ~Anteroom();
  Anteroom(const Anteroom&) = delete;
  Anteroom& operator=(const Anteroom&) = delete;

  /// From any thread.
  void add(core::FileHandle socket);

 private:
  struct Waiting {
    core::FileHandle socket;
    std::chrono::steady_clock::time_point since;
  };
  using Guests = std::map<std::uint64_t, Waiting>;

  void watch(const std::stop_token& stop);
  void look(std::uint64_t number);
  void dismissImpatient();

  std::function<void(core::FileHandle)> admit_;
  core::FileHandle events_;
  std::mutex mutex_;
  Guests guests_;  // by number, which grows: the oldest first
  std::uint64_t next_ = 0;
  std::jthread watcher_;  // last: it uses the others
};

}  // namespace poinsot::preview
