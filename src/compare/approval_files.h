// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::compare {

/// One file that changes when a new picture is approved. If there is neither a source nor a text, the file is
/// removed.
struct ApprovalFile {
  std::filesystem::path place;
  std::filesystem::path source = {};  ///< file whose copy replaces `place`
  std::string text = {};              ///< text that replaces `place`
};

/// Content of a file: its size and two identifiers, in hexadecimal.
struct FileState {
  std::size_t size = 0;
  std::string sha256;
  std::string git;  ///< identifier of the content in a git repository
};

/// ApprovalFile with what is needed to change the file elsewhere, or to refuse if it is another file there.
struct ApprovalStep {
  std::filesystem::path place;             ///< below the root
  std::optional<FileState> before, after;  ///< nullopt if the file does not exist
  std::filesystem::path source;  ///< relative to the page; empty if there is a text, or nothing is written
  std::string text;
  bool isEmbedded = false;  ///< whether the page embeds the new content
};

/// Returns the changes of files for a page. Empty if a file is outside `root` or cannot be read.
/// @param page  the page's own file, to which the paths of sources are relative
/// @param embedded  bytes of a source that the page embeds; may be empty
std::vector<ApprovalStep> approvalSteps(const std::vector<ApprovalFile>& files, const std::filesystem::path& root,
                                        const std::filesystem::path& page, const std::string& embedded);

/// Returns the folder to which paths of approvals are relative: the git work tree around `place`, or else the
/// current folder.
std::filesystem::path approvalRoot(const std::filesystem::path& place);

}  // namespace poinsot::compare
