// SPDX-License-Identifier: Apache-2.0
#include "core/file_names.h"

#include <system_error>

#include "core/text.h"

namespace poinsot::core {
namespace {

namespace fs = std::filesystem;

/// Returns whether the file system ignores case in names, judged by the name of `folder`. If the folder is
/// missing, tests its nearest existing parent.
bool ignoresCase(fs::path folder) {
  std::error_code ignored;
  while (!fs::exists(folder, ignored) || folder.filename().empty()) {
    if (!folder.has_relative_path()) return false;
    folder = folder.parent_path();
  }
  std::string other = folder.filename();
  for (char& c : other)
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) c = static_cast<char>(c ^ ('a' ^ 'A'));
  return other != folder.filename().native() && fs::equivalent(folder, folder.parent_path() / other, ignored);
}

}  // namespace

std::string FileNames::of(const fs::path& file) {
  const fs::path whole = fs::absolute(file);
  const auto [folder, isNew] = folders_.try_emplace(whole.parent_path());
  if (isNew) {
    std::error_code failure;  // ignored: later checks of the file report the reason
    const fs::path canonical = fs::weakly_canonical(folder->first, failure);
    folder->second.canonical = failure ? folder->first : canonical;
    folder->second.ignoresCase = ignoresCase(folder->second.canonical);
  }
  const fs::path name = folder->second.canonical / whole.filename();
  return folder->second.ignoresCase ? lowered(name.native()) : name.native();
}

}  // namespace poinsot::core
