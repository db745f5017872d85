// SPDX-License-Identifier: Apache-2.0
#include "job/segment_stream.h"

#include <fmt/format.h>
#include <limits.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "core/text.h"
#include "process/interrupt.h"

namespace poinsot::job {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Waits until standard output accepts data or a signal arrives. @returns 0 or an errno; ECANCELED after a signal
int awaitRoom() {
  pollfd watched[2] = {{STDOUT_FILENO, POLLOUT, 0}, {process::interruptFd(), POLLIN, 0}};
  while (poll(watched, 2, -1) < 0)
    if (errno != EINTR) return errno;
  return watched[1].revents != 0 ? ECANCELED : 0;
}

/// Writes all bytes, in pieces of at most PIPE_BUF, because a ready pipe accepts that size without blocking.
/// @returns 0 or an errno
int writeOut(Bytes bytes) {
  while (!bytes.empty()) {
    if (const int code = awaitRoom(); code != 0) return code;
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), std::min<std::size_t>(bytes.size(), PIPE_BUF));
    if (written < 0 && errno != EINTR && errno != EAGAIN) return errno;
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

[[noreturn]] void failStream(int code) {
  if (code == EPIPE) throw core::BrokenPipe();
  throw core::ioError(fmt::format("standard output: {}", core::systemReason(code)));
}

}  // namespace

SegmentStream::SegmentStream(const request::OutputTarget& target, const JobRecord& job,
                             std::filesystem::path workFolder)
    : target_(target), workFolder_(std::move(workFolder)), next_(job.frames.first) {
  if (target.kind == request::OutputKind::kFilm) film_.emplace(writeOut, job.film);
}

void SegmentStream::add(const request::FrameRange& segment) {
  ready_.push_back(segment);
  std::ranges::sort(ready_, {}, &request::FrameRange::first);
  while (!ready_.empty() && ready_.front().first == next_) {
    send(ready_.front());
    next_ = ready_.front().last + 1;
    ready_.erase(ready_.begin());
  }
}

void SegmentStream::send(const request::FrameRange& segment) {
  for (const auto& file : segmentFiles(workFolder_, target_, segment)) {
    if (film_)
      film_->append(file);
    else
      sendFile(file);
    std::filesystem::remove(file);
  }
}

void SegmentStream::sendFile(const std::filesystem::path& file) const {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in || bytes.empty()) throw core::ioError(core::printable(file.native()) + ": cannot be read again");
  if (const int code = writeOut({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}); code != 0)
    failStream(code);
}

void SegmentStream::finish() {
  if (film_) film_->finish();
  // Ignores failure for pipes and terminals, which cannot be synced.
  if (fsync(STDOUT_FILENO) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP) failStream(errno);
}

}  // namespace poinsot::job
