// SPDX-License-Identifier: Apache-2.0
#include "output/file_kind.h"

#include <utility>

#include "core/error.h"
#include "core/regular_file.h"
#include "image/png_file.h"
#include "output/film.h"

namespace poinsot::output {
namespace {

bool isDrawn(const std::filesystem::path& file) {
  return image::isOwnPng(file) || isOwnFilm(file) || figure::isOwnFigure(file);
}

bool beginsWith(const std::filesystem::path& file, const std::string& mark) try {
  const core::FileHandle handle = core::openForReading(file);
  if (!handle) return false;
  const std::string start = core::bytesOf(handle, mark.size(), core::ErrorKind::kIo);
  return start.empty() || start.starts_with(mark);
} catch (const core::Error&) {  // a pipe, a folder or an unreadable file
  return false;
}

}  // namespace

const FileKind& drawnKind() {
  static const FileKind kind{"", isDrawn};
  return kind;
}

FileKind textKind(std::string name, std::string mark) {
  return {std::move(name),
          [mark = std::move(mark)](const std::filesystem::path& file) { return beginsWith(file, mark); }};
}

FileKind markedKind(std::string name, const figure::CommentMark& mark) {
  return {std::move(name),
          [mark](const std::filesystem::path& file) { return figure::markedRest(file, mark).has_value(); }};
}

}  // namespace poinsot::output
