// SPDX-License-Identifier: Apache-2.0
#include "core/file_batch.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <utility>

#include "core/abandoned_files.h"
#include "core/expect.h"
#include "core/file_error.h"
#include "core/text.h"

namespace poinsot::core {
namespace {

using std::filesystem::path;

[[noreturn]] void fail(const path& file, int code) {
  throw FileError(ErrorKind::kIo,
                  fmt::format("{}: cannot be put in place: {}", printable(file.native()), std::strerror(code)),
                  file, code);
}

mode_t kindOf(const path& file) {
  struct stat status {};
  return ::lstat(file.c_str(), &status) == 0 ? status.st_mode & S_IFMT : 0;
}

/// Returns an unused name for an old file that is moved out of the way, in a folder on the same file system.
/// @param ending  ".tmp" lets later runs remove the file; they keep files with other endings
path freeName(const path& folder, const path& file, const char* ending = ".tmp") {
  constexpr int kAttempts = 1000;
  for (int attempt = 0; attempt < kAttempts; ++attempt)
    if (path name = temporaryName(folder, file, attempt).replace_extension(ending); kindOf(name) == 0) return name;
  fail(file, EEXIST);
}

std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

AtomicFile written(const path& target, std::span<const std::uint8_t> bytes, const path& temporaryFolder = {}) {
  AtomicFile file(target, temporaryFolder);
  file.write(bytes);
  return file;
}

}  // namespace

/// Log of the renamed files. The destructor restores all names unless keep() was called.
class FileBatch::Changes {
 public:
  explicit Changes(std::size_t most) { changes_.reserve(most); }
  Changes(const Changes&) = delete;
  Changes& operator=(const Changes&) = delete;

  ~Changes() { takeBack(); }

  /// Restores all names. Returns a message about the names that could not be restored, or an empty text.
  std::string takeBack() {
    std::string lost;
    for (; !changes_.empty(); changes_.pop_back())
      if (const Change& change = changes_.back(); !takeBack(change))
        lost += fmt::format("; the old {} is now named {}: rename it back", printable(change.name.native()),
                            printable(change.aside.native()));
    return lost;
  }

  void putAside(const path& name, const path& folder) {
    const mode_t kind = kindOf(name);
    if (kind == 0) return;
    if (kind == S_IFDIR) fail(name, EISDIR);
    move(begin(name, folder));
  }

  void putAside(const AtomicFile& file) { putAside(file.target(), folderOf(file.temporary())); }

  /// Renames a file to its target, so that the target exists at any time: either the old file first gets a second
  /// link, or the two names are swapped. Some file systems support neither. There, a single file is renamed and
  /// cannot be restored; in a batch, the old file is first renamed to a hidden name.
  void replace(AtomicFile& file) {
    const mode_t kind = kindOf(file.target());
    if (kind == S_IFDIR) fail(file.target(), EISDIR);
    Change& change = begin(file.target(), folderOf(file.temporary()));
    change.linked = kind != 0 && ::link(change.name.c_str(), change.aside.c_str()) == 0;
    if (kind != 0 && !change.linked) {
      if (exchange(change, file)) return;
      if (changes_.capacity() == 1) {
        changes_.clear();
        return file.rename();
      }
      // The old file has only its hidden name for a moment. With the ending ".old", later runs do not remove it.
      change.aside = freeName(folderOf(change.name), change.name, ".old");
      move(change);
    }
    file.rename();
    change.renamed = true;
  }

  void keep() {
    // If a hidden file cannot be removed, no exception is needed: all files of the batch are complete.
    for (const Change& change : changes_)
      if (change.moved || change.linked) ::unlink(change.aside.c_str());
    changes_.clear();
  }

 private:
  struct Change {
    path name, aside;      ///< path of a file, and hidden path of the file that it replaces
    bool moved = false;    ///< the old file has only the hidden name `aside`
    bool linked = false;   ///< the old file has both names, `name` and `aside`
    bool renamed = false;  ///< `name` is the new file
  };

  // Allocates all memory before the rename, so that no rename is left without a record.
  Change& begin(const path& name, const path& folder) {
    POINSOT_EXPECT(changes_.size() < changes_.capacity());
    return changes_.emplace_back(Change{name, freeName(folder, name)});
  }

  static bool exchange(Change& change, AtomicFile& file) {
    path temporary = file.temporary();
    if (!file.exchange()) return false;
    change.aside = std::move(temporary);
    return change.linked = change.renamed = true;
  }

  static bool takeBack(const Change& change) {
    if (change.moved || (change.linked && change.renamed))
      return std::rename(change.aside.c_str(), change.name.c_str()) == 0;
    if (change.linked || change.renamed) ::unlink((change.linked ? change.aside : change.name).c_str());
    return true;
  }

  static void move(Change& change) {
    if (std::rename(change.name.c_str(), change.aside.c_str()) != 0) fail(change.name, errno);
    change.moved = true;
  }

  std::vector<Change> changes_;
};

// Closes each file at once, because a large batch would use too many open descriptors.
AtomicFile FileBatch::finished(AtomicFile file) {
  file.finish(Durability::kSynced);
  folders_.insert(folderOf(file.target()));
  return file;
}

void FileBatch::add(AtomicFile file) { groups_.push_back({finished(std::move(file)), {}, {}}); }

void FileBatch::add(FileBatch&& others) {
  POINSOT_EXPECT(others.appended_.empty());
  std::ranges::move(others.groups_, std::back_inserter(groups_));
  std::ranges::move(others.removed_, std::back_inserter(removed_));
  folders_.merge(others.folders_);
}

void FileBatch::addBeside(AtomicFile file) {
  POINSOT_EXPECT(!groups_.empty());
  groups_.back().beside.push_back(finished(std::move(file)));
}

void FileBatch::removeBeside(path file) {
  POINSOT_EXPECT(!groups_.empty());
  groups_.back().removed.push_back(std::move(file));
}

void FileBatch::write(const path& target, std::span<const std::uint8_t> bytes) { add(written(target, bytes)); }

void FileBatch::write(const path& target, std::string_view text) { write(target, bytesOf(text)); }

void FileBatch::writeBeside(const path& target, std::span<const std::uint8_t> bytes, const path& temporaryFolder) {
  addBeside(written(target, bytes, temporaryFolder));
}

void FileBatch::writeBeside(const path& target, std::string_view text, const path& temporaryFolder) {
  writeBeside(target, bytesOf(text), temporaryFolder);
}

void FileBatch::remove(path file) {
  folders_.insert(folderOf(file));
  removed_.push_back(std::move(file));
}

void FileBatch::append(const path& target, std::string_view text) {
  POINSOT_EXPECT(appended_.empty());
  appended_ = target;
  appendedText_ = text;
}

const path& FileBatch::contentOf(const path& target) const {
  const auto found = std::ranges::find(groups_, target, [](const Group& group) { return group.main.target(); });
  return found == groups_.end() ? target : found->main.temporary();
}

void FileBatch::publish(Group& group, Changes& changes) {
  // Returns the folder for an old file: if possible, the folder in which the next run removes temporary files.
  const auto asideOf = [&](const path& file) {
    return folderOf(folderOf(file) == folderOf(group.main.target()) ? group.main.temporary() : file);
  };
  for (const path& file : group.removed) changes.putAside(file, asideOf(file));
  for (auto file = group.beside.rbegin(); file != group.beside.rend(); ++file) changes.putAside(*file);
  changes.replace(group.main);
  for (AtomicFile& file : group.beside) changes.replace(file);
}

void FileBatch::publish(Changes& changes) {
  for (const path& file : removed_) changes.putAside(file, folderOf(file));
  for (Group& group : groups_) publish(group, changes);
  for (const path& folder : folders_) syncFolderOf(folder / ".");
  // Appends last, because appended text cannot be removed again: other processes may write to the same file.
  if (!appended_.empty()) appendToFile(appended_, appendedText_);
}

void FileBatch::commit() {
  POINSOT_EXPECT(!std::exchange(isCommitted_, true));
  std::size_t most = removed_.size();
  for (const Group& group : groups_) most += 1 + 2 * group.beside.size() + group.removed.size();
  Changes changes(most);
  try {
    publish(changes);
  } catch (const Error& error) {
    const std::string lost = changes.takeBack();
    if (lost.empty()) throw;
    throw Error(error.kind(), error.what() + lost);
  }
  changes.keep();
}

}  // namespace poinsot::core
