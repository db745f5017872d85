// SPDX-License-Identifier: Apache-2.0
#include "scene/file_text.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace poinsot::scene {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw core::Error(core::ErrorKind::kScene, why); }

[[noreturn]] void refuseWithErrno() { refuse(std::generic_category().message(errno)); }

void expectRegular(const OpenFile& file) {
  struct stat status {};
  if (!file || ::fstat(file.handle(), &status) != 0) refuseWithErrno();
  if (S_ISDIR(status.st_mode)) refuse("it is a directory");
  if (!S_ISREG(status.st_mode)) refuse("it is not a regular file");
}

}  // namespace

OpenFile::~OpenFile() {
  if (handle_ >= 0) ::close(handle_);
}

OpenFile::OpenFile(OpenFile&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
  std::swap(handle_, other.handle_);
  return *this;
}

std::string textOf(const OpenFile& file, std::size_t most) {
  expectRegular(file);
  std::string text;
  char buffer[1 << 16];
  while (text.size() <= most) {
    const ssize_t count = ::read(file.handle(), buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuseWithErrno();
    if (count == 0) break;
    text.append(buffer, static_cast<std::size_t>(count));
  }
  return text;
}

}  // namespace poinsot::scene
