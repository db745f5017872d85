// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/abi.h"

namespace poinsot::core {

/// Cache of canonical names, so that two paths can be compared even if their files do not exist yet. Resolves
/// links in the folder part, and converts to lower case if the file system ignores case. A link in the last
/// component is not resolved, because an output replaces the link and not its target.
class FileNames {
 public:
  std::string of(const std::filesystem::path& file);

 private:
  struct Folder {
    std::filesystem::path canonical;
    bool ignoresCase = false;
  };
  std::map<std::filesystem::path, Folder> folders_;
};

}  // namespace poinsot::core
