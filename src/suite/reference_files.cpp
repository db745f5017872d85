// SPDX-License-Identifier: Apache-2.0
#include "suite/reference_files.h"

#include <fmt/format.h>

namespace poinsot::suite {

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

}  // namespace poinsot::suite
