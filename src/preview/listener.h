// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <httplib.h>

#include <atomic>

#undef _res  // a macro of <resolv.h>, which httplib.h brings; Eigen has arguments of that name

#include "core/file_handle.h"
#include "preview/pending_connections.h"

namespace poinsot::preview {

/// The library's server, with threads for complete requests only. The library gives each connection a thread from
/// its first byte on, as long as the connection sends a byte in five seconds, and keeps the thread for a next
/// request. Here a thread starts with a complete header and ends with the answer.
class Listener : public httplib::Server {
 public:
  static constexpr std::size_t kThreads = 64;

  Listener();

  /// Lengthens the queue of new connections: that of the library drops the sixth, which retries after seconds.
  /// @pre it was bound.
  void widen();
  /// Answers until end(). @pre it was bound.
  void serve();
  /// Ends serve(), also one that has not begun. May be called from any thread.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;
  void answer(const core::FileHandle& socket);
  /// Has the library answer one request. A template, as its versions differ in what they ask for.
  template <class Self>
  static void process(Self& self, httplib::Stream& connection);

  PendingConnections* pending_ = nullptr;  // while it serves
  std::atomic<bool> serving_ = false, ended_ = false;
};

}  // namespace poinsot::preview
