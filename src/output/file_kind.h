// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "figure/mark.h"

namespace poinsot::output {

/// A kind of output: earlier ones of a kind are replaced by new ones without --force.
struct FileKind {
  std::string name;  ///< for messages: "a manifest"; empty for what draws a scene
  /// Whether a file is an earlier one. Empty where no file may be taken for one.
  std::function<bool(const std::filesystem::path&)> isOwn;
};

/// Pictures, films and figures: what draws a scene.
const FileKind& drawnKind();

/// Text that begins with these words. An empty file is one of any such kind, as nothing is lost with it.
FileKind textKind(std::string name, std::string mark);

/// Text that carries a mark of this program and was not changed since.
FileKind markedKind(std::string name, const figure::CommentMark& mark);

}  // namespace poinsot::output
