// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <httplib.h>

#undef _res  // a macro of <resolv.h>, which httplib.h brings; Eigen has arguments of that name

#include "core/file_handle.h"
#include "preview/anteroom.h"

namespace poinsot::preview {

/// The library's server with another door: its own gives each connection a thread from its first byte on, for as
/// long as the connection sends one in five seconds, and then keeps the thread for a next request. Here a thread
/// begins with a whole head and ends with the answer.
class Listener : public httplib::Server {
 public:
  static constexpr std::size_t kThreads = 64;

  Listener();

  /// Lets many knock at once: the library's queue of five drops the others, who knock again after seconds.
  /// After it was bound.
  void widen();
  /// Answers until stop(). After it was bound.
  void serve();

 private:
  bool process_and_close_socket(socket_t socket) override;
  void answer(const core::FileHandle& socket);

  Anteroom* anteroom_ = nullptr;  // while it serves
};

}  // namespace poinsot::preview
