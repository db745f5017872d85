// SPDX-License-Identifier: Apache-2.0
#include "app/temporary_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <new>
#include <string>
#include <system_error>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::app {
namespace {

[[noreturn]] void refuse(const std::string& place, const std::error_code& why) {
  throw core::Error(core::ErrorKind::kIo,
                    fmt::format("{}: no temporary folder can be made: {} (TMPDIR names another place)",
                                core::printable(place), why.message()));
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code why;
  const std::filesystem::path place = std::filesystem::temp_directory_path(why);
  const char* asked = std::getenv("TMPDIR");
  if (why) refuse(asked ? asked : "/tmp", why);
  std::string name = place / "poinsot-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) refuse(place, std::error_code(errno, std::generic_category()));
  path_ = name;
}

TemporaryFolder TemporaryFolder::inMemory() {
  std::string name = "/dev/shm/poinsot-XXXXXX";
  return ::mkdtemp(name.data()) ? TemporaryFolder(name) : TemporaryFolder();
}

TemporaryFolder::~TemporaryFolder() {
  try {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  } catch (const std::bad_alloc&) {
    // It is under TMPDIR, where the system clears up.
  }
}

}  // namespace poinsot::app
