// SPDX-License-Identifier: Apache-2.0
#include "request/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/frame_clock.h"
#include "core/regular_file.h"
#include "core/sha256.h"
#include "core/text.h"
#include "figure/mark.h"
#include "output/film.h"
#include "output/film_format.h"
#include "text/math_setter.h"

namespace poinsot::request {
namespace {

using std::filesystem::path;

/// Formats a time such as "00:01:02,345".
/// @param sign  decimal sign of the format: ',' in SubRip, '.' in WebVTT
std::string stamp(std::int64_t time_ms, char sign) {
  const std::int64_t time_s = time_ms / 1000;
  return fmt::format("{:02}:{:02}:{:02}{}{:03}", time_s / 3600, time_s / 60 % 60, time_s % 60, sign,
                     time_ms % 1000);
}

std::string span(const Subtitle& subtitle, char sign) {
  return fmt::format("{} --> {}", stamp(subtitle.from_ms, sign), stamp(subtitle.to_ms, sign));
}

constexpr std::string_view kDigestOfSrt = "NOTE sha256 of the .srt: ";

/// Returns the content of a file. Empty if the file is missing, unreadable, or larger than 16 MiB.
std::string contentOf(const std::filesystem::path& file) try {
  constexpr std::size_t kMostBytes = std::size_t{16} << 20;
  return core::readRegularFile(file, kMostBytes, core::ErrorKind::kIo);
} catch (const core::Error&) {
  return "";
}

bool isOwnSrt(const std::filesystem::path& srt, const std::filesystem::path& vtt) {
  const auto rest = figure::markedRest(vtt, figure::kVttMark);
  return rest && rest->starts_with(std::string(kDigestOfSrt) + core::toHex(core::sha256(contentOf(srt))));
}

}  // namespace

std::vector<Subtitle> subtitlesOf(const scene::Scene& scene, const FrameRange& frames) {
  const double begin_s = core::filmTime_s(frames.first, scene.time.fps),
               end_s = core::filmTime_s(frames.last + 1, scene.time.fps);
  const auto ms = [&](double film_s) {
    return static_cast<std::int64_t>(std::llround(1000 * (std::clamp(film_s, begin_s, end_s) - begin_s)));
  };
  std::vector<Subtitle> subtitles;
  for (const scene::Caption& caption : scene.timeline.captions) {
    const Subtitle subtitle{ms(caption.from_s), ms(caption.to_s), text::setTex(caption.text).plainText};
    if (subtitle.to_ms > subtitle.from_ms) subtitles.push_back(subtitle);
  }
  return subtitles;
}

std::string srtText(const std::vector<Subtitle>& subtitles) {
  std::string text;
  for (std::size_t i = 0; i < subtitles.size(); ++i)
    text += fmt::format("{}\n{}\n{}\n\n", i + 1, span(subtitles[i], ','), subtitles[i].text);
  return text;
}

std::string vttText(const std::vector<Subtitle>& subtitles) {
  std::string text = fmt::format("{}{}\n\n", kDigestOfSrt, core::toHex(core::sha256(srtText(subtitles))));
  for (const Subtitle& subtitle : subtitles)
    text += fmt::format("{}\n{}\n\n", span(subtitle, '.'), core::xmlText(subtitle.text));
  return figure::marked(figure::kVttMark, text);
}

std::vector<std::filesystem::path> subtitleFiles(const std::filesystem::path& film) {
  std::filesystem::path srt = film, vtt = film;
  return {srt.replace_extension(".srt"), vtt.replace_extension(".vtt")};
}

std::vector<std::filesystem::path> filmsWithSubtitlesOf(const std::filesystem::path& film) {
  std::vector<std::filesystem::path> films;
  for (const output::FilmContainer container : output::filmContainers()) {
    auto other = film;
    other.replace_extension(output::nameOf(container));
    if (other != film && output::isOwnFilm(other)) films.push_back(std::move(other));
  }
  return films;
}

bool replacesOthers(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film) {
  const std::string srt = contentOf(subtitleFiles(film)[0]);
  return !srt.empty() && srt != srtText(subtitles);
}

void enterSubtitles(output::RunFiles& files, const std::vector<Subtitle>& subtitles,
                    const std::filesystem::path& film) {
  if (subtitles.empty()) return;
  const auto names = subtitleFiles(film);
  const path &srt = names[0], &vtt = names[1];
  // An .srt file with the same text may also be replaced, because the user may have deleted its .vtt file.
  const output::FileKind srtKind{
      "captions", [&](const path& file) { return isOwnSrt(file, vtt) || contentOf(file) == srtText(subtitles); }};
  files.writes(srt, "captions", srtKind);
  files.writes(vtt, "captions", output::markedKind("captions", figure::kVttMark));
}

std::vector<path> ownSubtitleFiles(const path& film) {
  const auto names = subtitleFiles(film);
  std::vector<path> own;
  std::error_code ignored;
  if (std::filesystem::exists(names[0], ignored) && isOwnSrt(names[0], names[1])) own.push_back(names[0]);
  if (figure::markedRest(names[1], figure::kVttMark)) own.push_back(names[1]);
  return own;
}

// The .vtt file identifies the .srt file by its digest, so the .vtt file is written first and removed last.
void addSubtitles(core::FileBatch& batch, const std::vector<Subtitle>& subtitles, const path& film,
                  const path& temporaryFolder) {
  const auto names = subtitleFiles(film);
  if (!subtitles.empty()) {
    batch.writeBeside(names[1], vttText(subtitles), temporaryFolder);
    batch.writeBeside(names[0], srtText(subtitles), temporaryFolder);
  } else if (filmsWithSubtitlesOf(film).empty()) {
    for (path& file : ownSubtitleFiles(film)) batch.removeBeside(std::move(file));
  }
}

void addSubtitlesOfFinished(core::FileBatch& batch, const std::vector<Subtitle>& subtitles, const path& film) {
  if (subtitles.empty()) return;
  const auto names = subtitleFiles(film);
  batch.write(names[1], vttText(subtitles));
  batch.writeBeside(names[0], srtText(subtitles));
}

}  // namespace poinsot::request
