// SPDX-License-Identifier: Apache-2.0
#include "request/output_target.h"

#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/expect.h"
#include "core/text.h"
#include "figure/figure.h"
#include "output/film_format.h"
#include "output/frame_pattern.h"

namespace poinsot::request {

namespace {

[[noreturn]] void refuse(const std::string& name, std::string_view why) {
  throw core::usageError(
      fmt::format("output '{}': {}; possible names: {} (a film), NAME.png (one frame), NAME_{{frame:05}}.png (a "
                  "numbered picture per frame)",
                  core::printable(name), why, output::filmFormatsText()));
}

std::vector<std::string> filmAndPictureEndings() {
  std::vector<std::string> endings{".png"};
  for (const output::FilmContainer container : output::filmContainers())
    endings.push_back(fmt::format(".{}", output::nameOf(container)));
  return endings;
}

bool isStandardOutput(const std::filesystem::path& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
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
  if (figure == ".pdf" || figure == ".svg" || figure == ".tex") refuse(name, "`poinsot still` writes figures");
  if (isStandardOutput(path)) refuse(name, "for standard output give -o - with --format png or --format mp4");
  if (path.extension() != ".png" && !film)
    refuse(name, "unsupported file type" + core::smallLettersHint(name, filmAndPictureEndings()));
  const bool pattern = output::FramePattern::isPattern(name);
  if (film) {
    if (pattern) refuse(name, "a film is one file, so its name must not contain {frame}");
    return {OutputKind::kFilm, path};
  }
  if (!pattern) return {OutputKind::kPicture, path};
  static_cast<void>(output::FramePattern(name));  // throws if the pattern is malformed
  return {OutputKind::kSequence, path};
}

OutputTarget streamTarget(const std::string& format) {
  if (format == "mp4") return {OutputKind::kFilm, "-.mp4", true};
  if (format == "png") return {OutputKind::kSequence, "-{frame:09}.png", true};
  throw core::usageError(fmt::format("-o - writes to standard output: choose --format png or --format mp4{}",
                                     format.empty() ? "" : fmt::format("; got '{}'", core::printable(format))));
}

OutputTarget parseStillTarget(const std::string& name) {
  const std::filesystem::path path(name);
  if (figure::figureMedium(path)) return {OutputKind::kFigure, path};
  if (path.extension() == ".png" && !output::FramePattern::isPattern(name)) return {OutputKind::kPicture, path};
  const std::string hint =
      isStandardOutput(path)
          ? "; for standard output use poinsot render --format png -o - --frames K, where K is the frame's number"
          : core::smallLettersHint(name, {".png", ".pdf", ".svg", ".tex"});
  throw core::usageError(fmt::format("output '{}': a still is one NAME.png, NAME.pdf, NAME.svg or NAME.tex{}",
                                     core::printable(name), hint));
}

namespace {

output::Effort effortOf(const std::string& word) {
  if (word == "fast") return output::Effort::kFast;
  return word == "slow" ? output::Effort::kSlow : output::Effort::kMedium;
}

}  // namespace

output::FilmFormat filmFormat(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form) {
  const auto container = output::filmContainer(target.path);
  POINSOT_EXPECT(container);
  output::FilmFormat format;
  format.container = *container;
  format.codec = output::filmCodec(asked.codec).value_or(output::codecsOf(*container).front());
  format.chroma = asked.chroma == "4:4:4" ? output::Chroma::k444 : output::Chroma::k420;
  format.effort = effortOf(asked.effort);
  format.transparent = form.transparent;
  format.crf = asked.crf;
  return format;
}

}  // namespace poinsot::request
