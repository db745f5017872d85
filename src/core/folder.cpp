// SPDX-License-Identifier: Apache-2.0
#include "core/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::core {

namespace fs = std::filesystem;

std::vector<fs::path> filesIn(const fs::path& folder, bool links) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const bool isLink = entry.is_symlink(ignored);
    if (links ? isLink : !isLink && entry.is_regular_file(ignored)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void expectNoLinkAbove(const fs::path& file, const fs::path& folder) {
  fs::path above = folder;
  for (const fs::path& part : file.lexically_relative(folder).parent_path()) {
    above /= part;
    std::error_code ignored;
    if (!fs::is_symlink(above, ignored)) continue;
    throw ioError(fmt::format(
        "{}: is a symbolic link; references must be in real folders below {}: replace the link with a folder",
        printable(above.native()), printable(folder.native())));
  }
}

}  // namespace poinsot::core
