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

/// Holds connections until the header of their request is complete. One thread watches all of them, so a
/// connection that sends slowly, or nothing, blocks no other: it is closed after kTimeout, and the oldest is
/// closed if more than kMostPending are held.
class PendingConnections {
 public:
  static constexpr std::chrono::seconds kTimeout{5};
  static constexpr std::size_t kMostPending = 256;
  static constexpr std::size_t kLongestHeader = 32 << 10;  ///< bytes

  /// @param admit  takes a connection whose header can be read without waiting, and owns the socket from then on.
  ///               Called by the watching thread.
  explicit PendingConnections(std::function<void(core::FileHandle)> admit);
  ~PendingConnections();
  PendingConnections(const PendingConnections&) = delete;
  PendingConnections& operator=(const PendingConnections&) = delete;

  /// Adds a connection. Any thread may call this function.
  void add(core::FileHandle socket);

 private:
  struct Connection {
    core::FileHandle socket;
    std::chrono::steady_clock::time_point since;
  };
  using Pending = std::map<std::uint64_t, Connection>;

  void watch(const std::stop_token& stop);
  void look(std::uint64_t number);
  void closeTimedOut();

  std::function<void(core::FileHandle)> admit_;
  core::FileHandle events_;
  std::mutex mutex_;
  Pending pending_;  // by increasing number, so the oldest comes first
  std::uint64_t next_ = 0;
  std::jthread watcher_;  // declared last, because the thread uses the other members
};

}  // namespace poinsot::preview
