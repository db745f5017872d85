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

/// Files that one run reads and writes. Commands register every output before the work begins. No output may
/// replace another output or an input of the run. Only with --force may an output replace a file of the user.
///
/// Files are compared by device and inode, so that the spelling of a path does not matter. Missing files are
/// compared by core::FileNames. A file's role, such as "SCENE" or "--manifest", names it in messages. An empty
/// path counts as no file.
class RunFiles {
 public:
  explicit RunFiles(bool force = false) : force_(force) {}

  /// Registers an input. @throws core::Error(kUsage) if an output is the same file.
  void reads(const std::filesystem::path& file, std::string_view role);

  /// Registers all files that match a pattern as inputs. This includes files that do not exist yet: if an output
  /// matched the pattern, the next run would read it.
  /// @param pattern  description of the pattern for messages. @throws core::Error(kUsage) if an output matches.
  void readsMatching(std::function<bool(const std::filesystem::path&)> matches, std::string pattern);

  /// Registers an output, which may replace an earlier output of its kind or, with --force, any regular file.
  /// @throws core::Error(kUsage) if another file of the run is the same; core::Error(kIo) as checkTarget().
  void writes(const std::filesystem::path& file, std::string_view role, const FileKind& kind = drawnKind());
  /// Registers all frames of a sequence as outputs. @throws core::Error as writes() for one file, and as
  /// checkSequence().
  void writes(const FramePattern& pattern, std::int64_t first, std::int64_t last, std::string_view role);

  /// Registers an output whose missing parent folders will be created. @throws core::Error as writes().
  void writesInNewFolder(const std::filesystem::path& file, std::string_view role, const FileKind& kind);
  /// Registers an output to which text is appended. The file must be missing, empty or an earlier output of the
  /// kind; with --force, it may be any regular file.
  /// @throws core::Error(kUsage) as writes(); core::Error(kIo) as checkAddedTo().
  void addsTo(const std::filesystem::path& file, std::string_view role, const FileKind& kind);

  /// Registers an output without checking whether it may replace an existing file. @throws core::Error(kUsage) as
  /// writes().
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
