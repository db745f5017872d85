// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "figure/mark.h"

namespace poinsot::output {

/// Kind of an output file. A new output replaces an earlier one of the same kind without --force.
struct FileKind {
  std::string name;  ///< for messages, such as "a manifest"; empty for what draws a scene
  /// Predicate for earlier outputs of this kind. Empty if every existing file needs --force.
  std::function<bool(const std::filesystem::path&)> isOwn;
};

/// Returns the kind of everything that draws a scene: pictures, films and figures.
const FileKind& drawnKind();

/// Returns the kind of texts that begin with `mark`. An empty file counts as one, because nothing is lost with it.
FileKind textKind(std::string name, std::string mark);

/// Returns the kind of texts that carry a mark of this program and have not changed since.
FileKind markedKind(std::string name, const figure::CommentMark& mark);

}  // namespace poinsot::output
