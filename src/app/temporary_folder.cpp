// SPDX-License-Identifier: Apache-2.0
#include "app/temporary_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <new>
#include <string>
#include <system_error>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::app {

TemporaryFolder::TemporaryFolder() {
  std::error_code why;
  std::string name = (std::filesystem::temp_directory_path(why) / "poinsot-XXXXXX").native();
  if (!why && mkdtemp(name.data()) == nullptr) why.assign(errno, std::generic_category());
  if (why)
    throw core::Error(core::ErrorKind::kIo,
                      fmt::format("{}: no temporary folder can be made: {} (TMPDIR names another)",
                                  core::printable(name), why.message()));
  path_ = name;
}

TemporaryFolder TemporaryFolder::inMemory() {
  std::string name = "/dev/shm/poinsot-XXXXXX";
  return mkdtemp(name.data()) ? TemporaryFolder(name) : TemporaryFolder();
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
