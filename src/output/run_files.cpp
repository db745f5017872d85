// SPDX-License-Identifier: Apache-2.0
#include "output/run_files.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include "core/error.h"
#include "core/text.h"
#include "output/target_check.h"

namespace poinsot::output {
namespace {

using std::filesystem::path;

std::string words(const path& file, const std::string& role) {
  return fmt::format("{} {}", role, core::printable(file.native()));
}

}  // namespace

void RunFiles::expectApart(const Entry& earlier, const Entry& later) {
  if (!earlier.isOutput && !later.isOutput) return;
  const Entry& output = later.isOutput ? later : earlier;
  const Entry& other = later.isOutput ? earlier : later;
  throw core::usageError(fmt::format("{} is the same file as {}, which this run {}; choose another name",
                                     words(output.file, output.role), words(other.file, other.role),
                                     other.isOutput ? "also writes" : "reads"));
}

void RunFiles::expectApart(const Entry& entry, const Pattern& pattern) {
  if (!entry.isOutput || !pattern.matches(entry.file)) return;
  throw core::usageError(
      fmt::format("{} would match {}, so the next run would read it; choose another name or folder",
                  words(entry.file, entry.role), pattern.words));
}

void RunFiles::enter(Entry entry) {
  if (entry.file.empty()) return;
  const auto [sameName, newName] = byName_.try_emplace(names_.of(entry.file), entries_.size());
  if (!newName) expectApart(entries_[sameName->second], entry);
  struct stat status {};
  if (::stat(entry.file.c_str(), &status) == 0) {
    const auto [sameFile, newFile] = byNumber_.try_emplace({status.st_dev, status.st_ino}, entries_.size());
    if (!newFile) expectApart(entries_[sameFile->second], entry);
  }
  for (const Pattern& pattern : patterns_) expectApart(entry, pattern);
  entries_.push_back(std::move(entry));
}

void RunFiles::readsMatching(std::function<bool(const path&)> matches, std::string pattern) {
  patterns_.push_back({std::move(matches), std::move(pattern)});
  for (const Entry& entry : entries_) expectApart(entry, patterns_.back());
}

void RunFiles::reads(const path& file, std::string_view role) { enter({file, std::string(role), false}); }

void RunFiles::claims(const path& name, std::string_view role) { enter({name, std::string(role), true}); }

void RunFiles::writes(const path& file, std::string_view role, const FileKind& kind) {
  if (file.empty()) return;
  claims(file, role);
  checkTarget(file, force_, kind);
}

void RunFiles::writesInNewFolder(const path& file, std::string_view role, const FileKind& kind) {
  if (file.empty()) return;
  claims(file, role);
  checkTargetInNewFolder(file, force_, kind);
}

void RunFiles::addsTo(const path& file, std::string_view role, const FileKind& kind) {
  if (file.empty()) return;
  claims(file, role);
  checkAddedTo(file, force_, kind);
}

void RunFiles::writes(const FramePattern& pattern, std::int64_t first, std::int64_t last, std::string_view role) {
  for (std::int64_t k = first; k <= last; ++k) claims(pattern.path(k), role);
  checkSequence(pattern, first, last, force_);
}

}  // namespace poinsot::output
