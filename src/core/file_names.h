// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/abi.h"

namespace poinsot::core {

/// Gives every file one name, however its path is spelled, so that names can be compared where files cannot: they
/// may be missing still. Links among the folders are followed, and capitals become small letters where the file
/// system takes both for the same. The last part is not followed, as an output replaces a link, not its target.
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
