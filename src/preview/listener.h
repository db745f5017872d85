// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <httplib.h>

#include <atomic>

#undef _res  // macro of <resolv.h>, which httplib.h includes; Eigen has arguments of this name

#include "core/file_handle.h"
#include "preview/pending_connections.h"

namespace poinsot::preview {

/// HTTP server of cpp-httplib, with threads for complete requests only. The library by itself gives each
/// connection a thread from the first byte on, as long as the connection sends a byte every five seconds, and
/// keeps the thread for a next request. Here a thread starts with a complete header and ends with the answer.
class Listener : public httplib::Server {
 public:
  static constexpr std::size_t kThreads = 64;

  Listener();

  /// Lengthens the queue of new connections. With the library's queue, a sixth connection is dropped and retries
  /// after seconds.
  /// @pre the server was bound.
  void widen();
  /// Answers requests until end(). @pre the server was bound.
  void serve();
  /// Ends serve(), even if it has not begun. Any thread may call this function.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;
  void answer(const core::FileHandle& socket);
  /// Lets the library answer one request. A template, because the parameters differ between the library's
  /// versions.
  template <class Self>
  static void process(Self& self, httplib::Stream& connection);

  PendingConnections* pending_ = nullptr;  // set while serve() runs
  std::atomic<bool> serving_ = false, ended_ = false;
};

}  // namespace poinsot::preview
