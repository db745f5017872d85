// SPDX-License-Identifier: Apache-2.0
#include "preview/anteroom.h"

#include <sys/epoll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace poinsot::preview {
namespace {

constexpr int kPause_ms = 100;

enum class Head { kWhole, kToCome, kNone };

/// Looks at what has arrived without taking it.
Head headAt(int socket) {
  static thread_local std::array<char, Anteroom::kLongestHead> bytes;
  const ssize_t count = recv(socket, bytes.data(), bytes.size(), MSG_PEEK | MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Head::kToCome;
  if (count <= 0) return Head::kNone;
  const std::string_view text(bytes.data(), static_cast<std::size_t>(count));
  if (text.find("\r\n\r\n") != std::string_view::npos) return Head::kWhole;
  return text.size() < bytes.size() ? Head::kToCome : Head::kNone;
}

}  // namespace

Anteroom::Anteroom(std::function<void(core::FileHandle)> admit)
    : admit_(std::move(admit)), events_(epoll_create1(EPOLL_CLOEXEC)) {
  if (!events_)
    throw core::Error(core::ErrorKind::kIo,
                      "connections cannot be watched: " + std::generic_category().message(errno));
  watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

Anteroom::~Anteroom() = default;

void Anteroom::add(core::FileHandle socket) {
  const std::scoped_lock lock(mutex_);
  if (guests_.size() >= kMostWaiting) guests_.erase(guests_.begin());
  // On each arrival, not as long as something is there: what has arrived stays where it is until it is whole.
  epoll_event event{};
  event.events = EPOLLIN | EPOLLRDHUP | EPOLLET;
  event.data.u64 = next_;
  if (epoll_ctl(events_.get(), EPOLL_CTL_ADD, socket.get(), &event) != 0) return;
  guests_.emplace(next_++, Waiting{std::move(socket), std::chrono::steady_clock::now()});
}

void Anteroom::watch(const std::stop_token& stop) {
  std::array<epoll_event, 64> events{};
  while (!stop.stop_requested()) {
    const int count = epoll_wait(events_.get(), events.data(), static_cast<int>(events.size()), kPause_ms);
    for (int i = 0; i < count; ++i) look(events[static_cast<std::size_t>(i)].data.u64);
    dismissImpatient();
  }
}

void Anteroom::look(std::uint64_t number) {
  const std::scoped_lock lock(mutex_);
  const auto guest = guests_.find(number);
  if (guest == guests_.end()) return;  // dismissed meanwhile
  core::FileHandle& socket = guest->second.socket;
  const Head head = headAt(socket.get());
  if (head == Head::kToCome) return;
  if (head == Head::kWhole) {
    epoll_ctl(events_.get(), EPOLL_CTL_DEL, socket.get(), nullptr);
    admit_(std::move(socket));
  }
  guests_.erase(guest);
}

void Anteroom::dismissImpatient() {
  const std::scoped_lock lock(mutex_);
  const auto longAgo = std::chrono::steady_clock::now() - kPatience;
  while (!guests_.empty() && guests_.begin()->second.since < longAgo) guests_.erase(guests_.begin());
}

}  // namespace poinsot::preview
