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

/// Connections whose request header is incomplete. One thread watches all of them, so a slow connection does not
/// block others. A connection is closed after kTimeout. If there are more than kMostPending, the oldest is closed.
class PendingConnections {
 public:
  static constexpr std::chrono::seconds kTimeout{5};
  static constexpr std::size_t kMostPending = 256;
  static constexpr std::size_t kLongestHeader = 32 << 10;  ///< in bytes

  /// @param admit  called on the watching thread for each connection with a complete header; takes ownership of
  /// the socket
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
  Pending pending_;  // in the order of arrival, oldest first
  std::uint64_t next_ = 0;
  std::jthread watcher_;  // declared last, because the thread uses the other members
};

}  // namespace poinsot::preview
