// SPDX-License-Identifier: Apache-2.0
#include "app/output_target.h"

#include <fmt/format.h>

#include <string_view>

#include "core/error.h"
#include "core/text.h"
#include "output/figure.h"
#include "output/film_format.h"
#include "output/frame_pattern.h"

namespace poinsot::app {
namespace {

[[noreturn]] void refuse(const std::string& name, std::string_view why) {
  throw core::Error(core::ErrorKind::kUsage,
                    fmt::format("output '{}': {}; works: {} (a film), NAME.png (one frame), "
                                "NAME_{{frame:05}}.png (a numbered picture per frame)",
                                core::printable(name), why, output::filmFormatsText()));
}

}  // namespace

bool takesDeepPictures(const OutputTarget& target) {
  return target.kind == OutputKind::kPicture || target.kind == OutputKind::kSequence;
}

OutputTarget parseTarget(const std::string& name) {
  const std::filesystem::path path(name);
  if (name.empty() || !path.has_filename()) refuse(name, "not a file name");
  const bool film = output::filmContainer(path).has_value();
  const auto figure = path.extension();
  if (figure == ".pdf" || figure == ".svg" || figure == ".tex")
    refuse(name, "a figure is made by `poinsot still`");
  if (path.extension() != ".png" && !film) refuse(name, "this kind of file is not written");
  const bool pattern = output::FramePattern::isPattern(name);
  if (film) {
    if (pattern) refuse(name, "a film is one file and has no {frame}");
    return {OutputKind::kFilm, path};
  }
  if (!pattern) return {OutputKind::kPicture, path};
  static_cast<void>(output::FramePattern(name));  // throws unless it is a good one
  return {OutputKind::kSequence, path};
}

OutputTarget streamTarget(const std::string& format) {
  if (format == "mp4") return {OutputKind::kFilm, "-.mp4", true};
  if (format == "png") return {OutputKind::kSequence, "-{frame:09}.png", true};
  throw core::Error(core::ErrorKind::kUsage,
                    fmt::format("-o - writes to standard output: say what, with --format png or --format mp4{}",
                                format.empty() ? "" : fmt::format("; got '{}'", core::printable(format))));
}

OutputTarget parseStillTarget(const std::string& name) {
  const std::filesystem::path path(name);
  if (output::figureMedium(path)) return {OutputKind::kFigure, path};
  if (path.extension() == ".png" && !output::FramePattern::isPattern(name)) return {OutputKind::kPicture, path};
  throw core::Error(
      core::ErrorKind::kUsage,
      fmt::format("output '{}': a still is one NAME.png, NAME.pdf, NAME.svg or NAME.tex", core::printable(name)));
}

}  // namespace poinsot::app
