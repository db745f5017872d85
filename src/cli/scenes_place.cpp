// SPDX-License-Identifier: Apache-2.0
#include "cli/scenes_place.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/program_path.h"

namespace poinsot::cli {

std::string scenesPlace() {
  const char* place = std::getenv("POINSOT_SCENES");
  if (place && *place) return place;
  std::error_code ignored;
  const auto installed = core::programPath().parent_path().parent_path() / "share" / "poinsot" / "scenes";
  return std::filesystem::is_directory(installed, ignored) ? installed.string() : "scenes";
}

}  // namespace poinsot::cli
