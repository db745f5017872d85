// SPDX-License-Identifier: Apache-2.0
#include "cli/ci_environment.h"

#include <cstdlib>

namespace poinsot::cli {

std::filesystem::path attachmentRoot() {
  const char* folder = std::getenv("CI_PROJECT_DIR");
  return folder ? folder : "";
}

}  // namespace poinsot::cli
