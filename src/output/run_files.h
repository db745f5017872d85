// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "output/file_kind.h"
#include "output/frame_pattern.h"

namespace poinsot::output {

/// The files that one run reads and writes. Every output is entered before the work begins: no output may replace
/// another one or an input of the run, and files of the user's are replaced only by --force.
///
/// Files are compared as files, by device and inode, and by name in the folder that they are in; how a path is
/// spelled does not count. Roles name files in messages: "SCENE", "--manifest". An empty path is no file.
class RunFiles {
 public:
  explicit RunFiles(bool force = false) : force_(force) {}

  /// Enters an input. @throws core::Error(kUsage) if an output is the same file.
  void reads(const std::filesystem::path& file, std::string_view role);

  /// Enters an output that replaces earlier ones of its kind, or any regular file with --force.
  /// @throws core::Error(kUsage) if another file of the run is the same; core::Error(kIo) as checkTarget().
  void writes(const std::filesystem::path& file, std::string_view role, const FileKind& kind = drawnKind());
  /// Enters all frames of a sequence. @throws as writes(), and checkSequence().
  void writes(const FramePattern& pattern, std::int64_t first, std::int64_t last, std::string_view role);

  /// Enters an output without a look at what is there: text is added to it, its folder is not made yet, or it is a
  /// folder itself.
  /// @throws core::Error(kUsage) if another file of the run is the same.
  void claims(const std::filesystem::path& file, std::string_view role);

 private:
  struct Entry {
    std::filesystem::path file;
    std::string role;
    bool isOutput = false;
  };
  void enter(Entry entry);
  std::string nameOf(const std::filesystem::path& file);
  /// @throws core::Error(kUsage) if one of the two is an output.
  static void expectApart(const Entry& earlier, const Entry& later);

  bool force_;
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> byName_;                ///< index of an entry
  std::map<std::pair<dev_t, ino_t>, std::size_t> byNumber_;  ///< of those that exist
  std::map<std::string, std::string> folders_;               ///< canonical names of folders
};

}  // namespace poinsot::output
