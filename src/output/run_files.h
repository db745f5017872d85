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

/// Files that one run reads and writes. Commands enter every output before the work begins. No output may replace
/// another output or an input of the run, and only --force lets an output replace files of the user.
///
/// Files are compared by device and inode or, if they are missing, by core::FileNames. How a path is spelled does
/// not matter. Roles name files in messages: "SCENE", "--manifest". An empty path counts as no file.
class RunFiles {
 public:
  explicit RunFiles(bool force = false) : force_(force) {}

  /// Enters an input. @throws core::Error(kUsage) if an output is the same file.
  void reads(const std::filesystem::path& file, std::string_view role);

  /// Enters all files that match a pattern, existing or not, because the next run would read an output among them.
  /// @param pattern  the pattern in words, for messages. @throws core::Error(kUsage) if an output matches.
  void readsMatching(std::function<bool(const std::filesystem::path&)> matches, std::string pattern);

  /// Enters an output that replaces an earlier one of its kind or, with --force, any regular file.
  /// @throws core::Error(kUsage) if another file of the run is the same; core::Error(kIo) as checkTarget().
  void writes(const std::filesystem::path& file, std::string_view role, const FileKind& kind = drawnKind());
  /// Enters all frames of a sequence. @throws core::Error as writes() for one file, and as checkSequence().
  void writes(const FramePattern& pattern, std::int64_t first, std::int64_t last, std::string_view role);

  /// Enters an output whose missing parent folders are created for it. @throws core::Error as writes().
  void writesInNewFolder(const std::filesystem::path& file, std::string_view role, const FileKind& kind);
  /// Enters an output to which text is appended. The file must be missing, empty or of the kind or, with --force,
  /// any regular file.
  /// @throws core::Error(kUsage) as writes(); core::Error(kIo) as checkAddedTo().
  void addsTo(const std::filesystem::path& file, std::string_view role, const FileKind& kind);

  /// Enters a name without checking the file that has it. @throws core::Error(kUsage) as writes().
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
  static void expectApart(const Entry& earlier, const Entry& later);
  static void expectApart(const Entry& entry, const Pattern& pattern);

  bool force_;
  std::vector<Entry> entries_;
  std::vector<Pattern> patterns_;
  std::map<std::string, std::size_t> byName_;
  std::map<std::pair<dev_t, ino_t>, std::size_t> byNumber_;
  core::FileNames names_;
};

}  // namespace poinsot::output
