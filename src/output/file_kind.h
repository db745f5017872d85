// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "figure/mark.h"

namespace poinsot::output {

/// Kind of an output file, such as a manifest. A new output may replace an earlier one of the same kind without
/// --force.
struct FileKind {
  std::string name;  ///< name for messages, such as "a manifest"; empty for drawnKind()
  /// Returns whether a file is an earlier output of this kind. If empty, every existing file needs --force.
  std::function<bool(const std::filesystem::path&)> isOwn;
};

/// Returns the kind of all outputs that show a scene: pictures, films and figures.
const FileKind& drawnKind();

/// Returns the kind of text files that begin with `mark`. An empty file counts too, because replacing it loses
/// nothing.
FileKind textKind(std::string name, std::string mark);

/// Returns the kind of text files that have a mark of this program and were not changed afterwards.
FileKind markedKind(std::string name, const figure::CommentMark& mark);

}  // namespace poinsot::output
