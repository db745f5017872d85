// SPDX-License-Identifier: Apache-2.0
#include "cli/scenes_place.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace poinsot::cli {

std::string scenesPlace() {
  const char* place = std::getenv("POINSOT_SCENES");
  if (place && *place) return place;
  std::error_code failure;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failure);
  const auto installed = program.parent_path().parent_path() / "share" / "poinsot" / "scenes";
  return !failure && std::filesystem::is_directory(installed, failure) ? installed.string() : "scenes";
}

}  // namespace poinsot::cli
