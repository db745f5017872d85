// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <httplib.h>

#include <atomic>

#undef _res  // macro of <resolv.h>, included by httplib.h; Eigen has parameters of this name

#include "core/file_handle.h"
#include "preview/pending_connections.h"

namespace poinsot::preview {

/// HTTP server based on cpp-httplib that uses a thread only for the answer to a complete request. By itself,
/// cpp-httplib occupies a thread for each connection from its first byte on. A client that sends one byte every
/// five seconds would keep the thread.
class Listener : public httplib::Server {
 public:
  static constexpr std::size_t kThreads = 64;

  Listener();

  /// Lengthens the queue of new connections. With the default of cpp-httplib, a sixth connection would be dropped,
  /// and the browser would try again after seconds.
  /// @pre the server was bound.
  void widen();
  /// Answers requests until end(). @pre the server was bound.
  void serve();
  /// Ends serve(), even if serve() starts later. Any thread may call this function.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;
  void answer(const core::FileHandle& socket);
  /// Makes cpp-httplib answer one request. A template, because the parameters depend on the version of
  /// cpp-httplib.
  template <class Self>
  static void process(Self& self, httplib::Stream& connection);

  PendingConnections* pending_ = nullptr;  // not null while serve() runs
  std::atomic<bool> serving_ = false, ended_ = false;
};

}  // namespace poinsot::preview
