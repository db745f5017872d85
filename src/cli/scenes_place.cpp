// SPDX-License-Identifier: Apache-2.0
#include "cli/scenes_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "core/file_error.h"
#include "core/program_path.h"
#include "core/text.h"

namespace poinsot::cli {

namespace fs = std::filesystem;

std::string scenesPlace() {
  const char* place = std::getenv("POINSOT_SCENES");
  if (place && *place) return place;
  std::error_code ignored;
  const auto installed = core::programPath().parent_path().parent_path() / "share" / "poinsot" / "scenes";
  return fs::is_directory(installed, ignored) ? installed.string() : "scenes";
}

std::vector<fs::path> scenesIn(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    if (entry->path().extension() == ".toml") found.push_back(entry->path());
  const std::string shown = core::printable(folder.native());
  if (failure)
    throw core::FileError(
        core::ErrorKind::kIo,
        fmt::format("{}: {}; POINSOT_SCENES names the folder of the scenes", shown, failure.message()), folder,
        failure.value());
  if (found.empty()) throw core::usageError(fmt::format("{}: contains no scene (NAME.toml)", shown));
  std::ranges::sort(found);
  return found;
}

}  // namespace poinsot::cli
