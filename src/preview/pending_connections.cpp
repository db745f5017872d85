// SPDX-License-Identifier: Apache-2.0
#include "preview/pending_connections.h"

#include <sys/epoll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <exception>
#include <string_view>
#include <utility>

#include "core/error.h"

namespace poinsot::preview {
namespace {

constexpr int kPause_ms = 100;

enum class Header { kComplete, kIncomplete, kNone };

Header headerAt(int socket) {
  static thread_local std::array<char, PendingConnections::kLongestHeader> bytes;
  const ssize_t count = recv(socket, bytes.data(), bytes.size(), MSG_PEEK | MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Header::kIncomplete;
  if (count <= 0) return Header::kNone;
  const std::string_view text(bytes.data(), static_cast<std::size_t>(count));
  if (text.find("\r\n\r\n") != std::string_view::npos) return Header::kComplete;
  return text.size() < bytes.size() ? Header::kIncomplete : Header::kNone;
}

}  // namespace

PendingConnections::PendingConnections(std::function<void(core::FileHandle)> admit)
    : admit_(std::move(admit)), events_(epoll_create1(EPOLL_CLOEXEC)) {
  if (!events_) throw core::ioError("cannot watch connections: " + core::systemReason(errno));
  watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

PendingConnections::~PendingConnections() = default;

void PendingConnections::add(core::FileHandle socket) {
  const std::scoped_lock lock(mutex_);
  if (pending_.size() >= kMostPending) pending_.erase(pending_.begin());
  // Edge-triggered: reports only new bytes. Bytes stay in the socket until the header is complete, and would
  // otherwise be reported again and again.
  epoll_event event{};
  event.events = EPOLLIN | EPOLLRDHUP | EPOLLET;
  event.data.u64 = next_;
  if (epoll_ctl(events_.get(), EPOLL_CTL_ADD, socket.get(), &event) != 0) return;
  pending_.emplace(next_++, Connection{std::move(socket), std::chrono::steady_clock::now()});
}

void PendingConnections::watch(const std::stop_token& stop) {
  std::array<epoll_event, 64> events{};
  while (!stop.stop_requested()) {
    const int count = epoll_wait(events_.get(), events.data(), static_cast<int>(events.size()), kPause_ms);
    for (int i = 0; i < count; ++i) look(events[static_cast<std::size_t>(i)].data.u64);
    closeTimedOut();
  }
}

void PendingConnections::look(std::uint64_t number) try {
  const std::scoped_lock lock(mutex_);
  const auto found = pending_.find(number);
  if (found == pending_.end()) return;  // the connection was closed meanwhile
  const Header header = headerAt(found->second.socket.get());
  if (header == Header::kIncomplete) return;
  core::FileHandle socket = std::move(found->second.socket);  // closed on return, unless passed to admit_
  pending_.erase(found);
  if (header != Header::kComplete) return;
  epoll_ctl(events_.get(), EPOLL_CTL_DEL, socket.get(), nullptr);
  admit_(std::move(socket));
} catch (const std::exception&) {  // out of memory: only this connection is closed
}

void PendingConnections::closeTimedOut() {
  const std::scoped_lock lock(mutex_);
  const auto longAgo = std::chrono::steady_clock::now() - kTimeout;
  while (!pending_.empty() && pending_.begin()->second.since < longAgo) pending_.erase(pending_.begin());
}

}  // namespace poinsot::preview
