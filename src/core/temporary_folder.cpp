// SPDX-License-Identifier: Apache-2.0
#include "core/temporary_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include "core/file_error.h"
#include "core/text.h"

namespace poinsot::core {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& place, const std::error_code& why) {
  throw FileError(ErrorKind::kIo,
                  fmt::format("{}: cannot create a temporary folder: {} (set TMPDIR to use another folder)",
                              printable(place), why.message()),
                  place, why.value());
}

ClaimedFolder makeFolderIn(const fs::path& place) {
  removeAbandonedFolders(place);
  return makeClaimedFolder(place);
}

ClaimedFolder makeFolder() {
  std::error_code why;
  const fs::path place = fs::temp_directory_path(why);
  const char* asked = std::getenv("TMPDIR");
  if (why) refuse(asked ? asked : "/tmp", why);
  ClaimedFolder made = makeFolderIn(place);
  if (made.path.empty()) refuse(place, std::error_code(errno, std::generic_category()));
  return made;
}

}  // namespace

TemporaryFolder::TemporaryFolder() : TemporaryFolder(makeFolder()) {}

TemporaryFolder::TemporaryFolder(ClaimedFolder folder) : folder_(std::move(folder)) {}

TemporaryFolder TemporaryFolder::inMemory() {
  ClaimedFolder made = makeFolderIn("/dev/shm");
  return made.path.empty() ? TemporaryFolder() : TemporaryFolder(std::move(made));
}

TemporaryFolder::~TemporaryFolder() {
  try {
    removeClaimedFolder(folder_.path);
  } catch (const std::bad_alloc&) {
    // On failure, the folder stays in TMPDIR, which the system cleans up.
  }
}

}  // namespace poinsot::core
