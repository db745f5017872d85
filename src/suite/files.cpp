// SPDX-License-Identifier: Apache-2.0
#include "suite/files.h"

#include <algorithm>
#include <system_error>

#include "core/wildcard.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code ignored;  // a missing folder counts as an empty one
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored))
    if (!entry.path().filename().native().starts_with('.')) entries.push_back(folder / entry.path().filename());
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() == fs::file_type::directory;
}

/// Collects the files below a folder that match a part of a pattern: its components from `part` to `end`.
void collect(const fs::path& folder, fs::path::iterator part, const fs::path::iterator end,
             std::vector<fs::path>& files) {
  const auto next = std::next(part);
  if (*part == "**") {
    if (next == end) return;  // a trailing ** matches folders only
    collect(folder, next, end, files);
    for (const fs::path& entry : entriesOf(folder))
      if (isFolder(entry)) collect(entry, part, end, files);
    return;
  }
  for (const fs::path& entry : entriesOf(folder)) {
    if (!core::matchesWildcard(part->native(), entry.filename().native())) continue;
    if (next == end && !isFolder(entry))
      files.push_back(entry);
    else if (next != end && isFolder(entry))
      collect(entry, next, end, files);
  }
}

/// Reports whether the components of a path, from `name` on, match the components of a pattern, from `part` on.
bool matches(fs::path::iterator part, const fs::path::iterator end, fs::path::iterator name,
             const fs::path::iterator nameEnd) {
  if (part == end || name == nameEnd) return part == end && name == nameEnd;
  const bool isSeen = !name->native().starts_with('.');
  if (*part == "**")
    return matches(std::next(part), end, name, nameEnd) ||
           (isSeen && matches(part, end, std::next(name), nameEnd));
  return isSeen && core::matchesWildcard(part->native(), name->native()) &&
         matches(std::next(part), end, std::next(name), nameEnd);
}

/// Returns a file's path with links to folders resolved. The file itself may be missing, or a link.
fs::path withoutLinks(const fs::path& file) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(file, ignored).parent_path(), ignored) / file.filename();
}

/// Pattern in two parts: the folder before the first star, and the remaining components, of which there is at
/// least one.
struct SplitPattern {
  fs::path folder, rest;
};

SplitPattern split(const fs::path& folder, const fs::path& pattern) {
  SplitPattern parts{folder, {}};
  auto part = pattern.begin();
  const auto last = pattern.empty() ? pattern.end() : std::prev(pattern.end());
  for (; part != last && !isPattern(part->native()); ++part) parts.folder /= *part;
  for (; part != pattern.end(); ++part) parts.rest /= *part;
  return parts;
}

}  // namespace

bool isPattern(const std::string& path) { return path.find('*') != std::string::npos; }

fs::path fixedFolder(const fs::path& folder, const std::string& path) { return split(folder, path).folder; }

std::vector<MatchedFile> filesMatching(const fs::path& folder, const std::string& path) {
  if (!isPattern(path)) return {{folder / path, fs::path(path).stem()}};
  const auto [fixed, rest] = split(folder, path);
  std::vector<fs::path> files;
  collect(fixed, rest.begin(), rest.end(), files);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  std::vector<MatchedFile> matched;
  for (const fs::path& file : files) {
    const fs::path name = fixed.empty() ? file : file.lexically_relative(fixed);
    matched.push_back({file, (name.parent_path() / name.stem()).native()});
  }
  return matched;
}

bool isMatch(const fs::path& folder, const std::string& pattern, const fs::path& file) {
  const auto [fixed, rest] = split(folder, pattern);
  const fs::path name = withoutLinks(file).lexically_relative(withoutLinks(fixed / "x").parent_path());
  return matches(rest.begin(), rest.end(), name.begin(), name.end());
}

}  // namespace poinsot::suite
