// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace poinsot::compare {

/// One file that changes when a new picture is approved. If there is neither a source nor a text, the file is
/// removed.
struct ApprovalFile {
  std::filesystem::path place;
  std::filesystem::path source = {};  ///< file whose copy replaces `place`
  std::string text = {};              ///< text that replaces `place`
};

/// Describes the files for a page, so that the page can make a patch, and `golden approve` can change the files.
/// Each file has its path below `root`, and size, SHA-256 digest and git's identifier before and after.
/// @param page  the page's own file, to which the paths of sources are relative
/// @param embedded  bytes of a source that the page embeds; may be empty
/// @returns null if a file is outside `root` or cannot be read
nlohmann::ordered_json approvalJson(const std::vector<ApprovalFile>& files, const std::filesystem::path& root,
                                    const std::filesystem::path& page, const std::string& embedded);

/// Returns the folder to which paths of approvals are relative: the git work tree around `place`, or else the
/// current folder.
std::filesystem::path approvalRoot(const std::filesystem::path& place);

}  // namespace poinsot::compare
