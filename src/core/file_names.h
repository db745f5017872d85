// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/abi.h"

namespace poinsot::core {

/// Maps each path to one canonical name, so that paths can be compared even if the files do not exist yet.
/// Resolves links among the folders, and lowers capitals if the file system ignores case. A link in the last
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
