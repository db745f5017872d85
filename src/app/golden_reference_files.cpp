// SPDX-License-Identifier: Apache-2.0
#include "app/golden_reference_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::app {

namespace fs = std::filesystem;

ReferenceStem splitStem(const std::string& stem) {
  const auto at = stem.rfind('@');
  return at == std::string::npos ? ReferenceStem{stem, ""}
                                 : ReferenceStem{stem.substr(0, at), stem.substr(at + 1)};
}

std::string slugOf(const std::string& renderer) {
  std::string text;
  for (const char c : renderer) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (plain)
      text += c;
    else if (!text.empty() && text.back() != '_')
      text += '_';
  }
  while (!text.empty() && text.back() == '_') text.pop_back();
  return text.empty() ? "other" : text;
}

fs::path descriptionOf(const fs::path& picture) { return fs::path(picture).replace_extension(".json"); }

fs::path usualFile(const fs::path& folder, const GoldenName& name) {
  return folder / (name.name + name.extension);
}

fs::path fileFor(const std::string& renderer, const fs::path& usual) {
  return usual.parent_path() /
         fmt::format("{}@{}{}", usual.stem().native(), slugOf(renderer), usual.extension().native());
}

std::vector<fs::path> filesIn(const fs::path& folder, bool links) {
  std::vector<fs::path> files;
  std::error_code ignored;  // no folder has no files
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
    throw core::Error(
        core::ErrorKind::kIo,
        fmt::format("{}: is a link; references lie in real folders below {}: put a folder in its place",
                    core::printable(above.native()), core::printable(folder.native())));
  }
}

}  // namespace poinsot::app
