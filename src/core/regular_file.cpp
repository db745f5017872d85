// SPDX-License-Identifier: Apache-2.0
#include "core/regular_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/text.h"

namespace poinsot::core {
namespace {

/// Closes on every way out.
struct Descriptor {
  int number;
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

const char* whyNotRegular(mode_t mode) { return S_ISDIR(mode) ? "it is a directory" : "it is not a regular file"; }

}  // namespace

std::string readRegularFile(const std::filesystem::path& path, std::size_t mostBytes, ErrorKind kind) {
  const std::string name = printable(path.string());
  const auto refuse = [&](const char* why) { throw Error(kind, fmt::format("cannot read {}: {}", name, why)); };
  // O_NONBLOCK: opening a FIFO must not wait for its writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.number < 0) refuse(std::strerror(errno));
  struct stat status {};
  if (::fstat(file.number, &status) != 0) refuse(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) refuse(whyNotRegular(status.st_mode));
  std::string bytes;
  char buffer[1 << 16];
  while (bytes.size() <= mostBytes) {  // one byte too many is enough to refuse it
    const ssize_t count = ::read(file.number, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(std::strerror(errno));
    if (count == 0) return bytes;
    bytes.append(buffer, static_cast<std::size_t>(count));
  }
  throw Error(ErrorKind::kLimit,
              fmt::format("{} has more than {} bytes, the most that are read", name, mostBytes));
}

}  // namespace poinsot::core
