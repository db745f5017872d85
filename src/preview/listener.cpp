// SPDX-License-Identifier: Apache-2.0
#include "preview/listener.h"

#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

namespace poinsot::preview {
namespace {

constexpr time_t kTimeout_s = 5;

/// Return type of enqueue(): void in early versions of cpp-httplib; later a bool, true if the job was accepted.
using Taken = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));

/// Task queue that runs each job immediately, on the calling thread. A job only passes on a connection.
class AtOnce : public httplib::TaskQueue {
 public:
  Taken enqueue(std::function<void()> job) override { return job(), Taken(true); }
  void shutdown() override {}
};

/// Thread pool that ends with its scope, even after an exception. cpp-httplib requires shutdown() before
/// destruction.
class ScopedThreads {
 public:
  explicit ScopedThreads(std::size_t count) : pool_(count) {}
  ~ScopedThreads() { pool_.shutdown(); }
  ScopedThreads(const ScopedThreads&) = delete;
  ScopedThreads& operator=(const ScopedThreads&) = delete;

  void enqueue(std::function<void()> job) { pool_.enqueue(std::move(job)); }

 private:
  httplib::ThreadPool pool_;
};

/// Connection with the interface of a stream of cpp-httplib. No function is marked override, because the interface
/// differs between versions.
class Connection : public httplib::Stream {
 public:
  explicit Connection(int socket) : socket_(socket) {}

  bool is_readable() const { return true; }
  bool is_writable() const { return true; }
  bool wait_readable() const { return true; }
  bool wait_writable() const { return true; }
  time_t duration() const { return 0; }  // unused: PendingConnections enforces the deadline

  ssize_t read(char* to, std::size_t most) {
    if (taken_ == arrived_) {
      const ssize_t count = retried([&] { return recv(socket_, buffer_.data(), buffer_.size(), 0); });
      if (count <= 0) return count;
      taken_ = 0;
      arrived_ = static_cast<std::size_t>(count);
    }
    const std::size_t count = std::min(most, arrived_ - taken_);
    std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(taken_), count, to);
    taken_ += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* from, std::size_t count) {
    return retried([&] { return send(socket_, from, count, MSG_NOSIGNAL); });
  }

  // Unused, because every connection comes from this machine.
  void get_remote_ip_and_port(std::string& ip, int& port) const { ip.clear(), port = 0; }
  void get_local_ip_and_port(std::string& ip, int& port) const { ip.clear(), port = 0; }
  socket_t socket() const { return socket_; }

 private:
  template <class Call>
  static ssize_t retried(const Call& call) {
    ssize_t count = 0;
    do count = call();
    while (count < 0 && errno == EINTR);
    return count;
  }

  int socket_;
  std::array<char, 4096> buffer_;
  std::size_t taken_ = 0, arrived_ = 0;
};

}  // namespace

Listener::Listener() {
  new_task_queue = [] { return new AtOnce; };
}

void Listener::widen() { ::listen(svr_sock_, SOMAXCONN); }

void Listener::serve() {
  ScopedThreads threads(kThreads);
  PendingConnections pending([&](core::FileHandle socket) {
    auto shared = std::make_shared<core::FileHandle>(std::move(socket));  // shared, because jobs must be copyable
    threads.enqueue([this, shared] { answer(*shared); });
  });
  pending_ = &pending;
  serving_ = true;
  if (!ended_) listen_after_bind();
  serving_ = false;
}

void Listener::end() {
  ended_ = true;
  // Waits for the server's loop, because stop() of cpp-httplib has no effect before the loop runs.
  while (serving_ && !is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  stop();
}

bool Listener::process_and_close_socket(socket_t socket) {
  pending_->add(core::FileHandle(socket));
  return true;
}

template <class Self>
void Listener::process(Self& self, httplib::Stream& connection) {
  bool closed = false;
  if constexpr (requires { self.process_request(connection, true, closed, nullptr); })
    self.process_request(connection, true, closed, nullptr);
  else  // versions 0.15 and later expect the addresses of both ends
    self.process_request(connection, "", 0, "", 0, true, closed, nullptr);
}

void Listener::answer(const core::FileHandle& socket) {
  const timeval timeout{kTimeout_s, 0};  // time for each read or write
  for (const int which : {SO_RCVTIMEO, SO_SNDTIMEO})
    setsockopt(socket.get(), SOL_SOCKET, which, &timeout, sizeof timeout);
  Connection connection(socket.get());
  process(*this, connection);
  ::shutdown(socket.get(), SHUT_RDWR);
}

}  // namespace poinsot::preview
