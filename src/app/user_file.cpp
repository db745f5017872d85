// SPDX-License-Identifier: Apache-2.0
#include "app/user_file.h"

#include <cstdlib>

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

/// Of an environment variable; empty unless it is an absolute path, as the XDG specification has it.
fs::path folderNamed(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path folder = value ? value : "";
  return folder.is_absolute() ? folder : fs::path();
}

}  // namespace

fs::path userFile(std::string_view name) {
  fs::path folder = folderNamed("XDG_CONFIG_HOME");
  if (const fs::path home = folderNamed("HOME"); folder.empty() && !home.empty()) folder = home / ".config";
  return folder.empty() ? folder : folder / "poinsot" / name;
}

}  // namespace poinsot::app
