// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file_names.h"
#include "output/file_kind.h"
#include "output/frame_pattern.h"

namespace poinsot::output {

/// The files that one run reads and writes. Every output is entered before the work begins: no output may replace
/// another one or an input of the run, and files of the user's are replaced only by --force.
///
/// Files are compared as files, by device and inode, and by FileNames, where they are missing; how a path is
/// spelled does not count. Roles name files in messages: "SCENE", "--manifest". An empty path is no file.
class RunFiles {
 public:
  explicit RunFiles(bool force = false) : force_(force) {}

  /// Enters an input. @throws core::Error(kUsage) if an output is the same file.
  void reads(const std::filesystem::path& file, std::string_view role);

  /// Enters all files, there or not, that a pattern matches: the next run would read an output among them.
  /// @param pattern  its words for messages. @throws core::Error(kUsage) if an output is one of them.
  void readsMatching(std::function<bool(const std::filesystem::path&)> matches, std::string pattern);

  /// Enters an output that replaces earlier ones of its kind, or any regular file with --force.
  /// @throws core::Error(kUsage) if another file of the run is the same; core::Error(kIo) as checkTarget().
  void writes(const std::filesystem::path& file, std::string_view role, const FileKind& kind = drawnKind());
  /// Enters all frames of a sequence. @throws as writes(), and checkSequence().
  void writes(const FramePattern& pattern, std::int64_t first, std::int64_t last, std::string_view role);

  /// Likewise where missing folders above the file are made for it. @throws as writes().
  void writesInNewFolder(const std::filesystem::path& file, std::string_view role, const FileKind& kind);
  /// Enters an output that text is added to, if it is missing, empty or of the kind, or any regular file with
  /// --force.
  /// @throws core::Error(kUsage) as writes(); core::Error(kIo) as checkAddedTo().
  void addsTo(const std::filesystem::path& file, std::string_view role, const FileKind& kind);

  /// Enters a name without a look at what is there. @throws core::Error(kUsage) as writes().
  void claims(const std::filesystem::path& name, std::string_view role);

 private:
  struct Entry {
    std::filesystem::path file;
    std::string role;
    bool isOutput = false;
  };
  struct Pattern {
    std::function<bool(const std::filesystem::path&)> matches;
    std::string words;
  };
  void enter(Entry entry);
  /// @throws core::Error(kUsage) if one of the two is an output.
  static void expectApart(const Entry& earlier, const Entry& later);
  static void expectApart(const Entry& entry, const Pattern& pattern);

  bool force_;
  std::vector<Entry> entries_;
  std::vector<Pattern> patterns_;
  std::map<std::string, std::size_t> byName_;                ///< index of an entry
  std::map<std::pair<dev_t, ino_t>, std::size_t> byNumber_;  ///< of those that exist
  core::FileNames names_;
};

}  // namespace poinsot::output
