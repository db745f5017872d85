// SPDX-License-Identifier: Apache-2.0
#include "app/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/frame_clock.h"
#include "core/regular_file.h"
#include "core/sha256.h"
#include "output/atomic_file.h"
#include "output/figure_mark.h"
#include "output/film.h"
#include "output/film_format.h"
#include "output/target_check.h"
#include "text/math_setter.h"

namespace poinsot::app {
namespace {

/// "00:01:02,345" with the sign before the milliseconds that the format has.
std::string stamp(std::int64_t time_ms, char sign) {
  const std::int64_t time_s = time_ms / 1000;
  return fmt::format("{:02}:{:02}:{:02}{}{:03}", time_s / 3600, time_s / 60 % 60, time_s % 60, sign,
                     time_ms % 1000);
}

std::string span(const Subtitle& subtitle, char sign) {
  return fmt::format("{} --> {}", stamp(subtitle.from_ms, sign), stamp(subtitle.to_ms, sign));
}

/// WebVTT's text is marked up like HTML.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else
      safe += c;
  }
  return safe;
}

constexpr std::string_view kDigestOfSrt = "NOTE sha256 of the .srt: ";

/// Returns the content; empty if the file is missing, cannot be read or is larger than any subtitles.
std::string textOf(const std::filesystem::path& file) try {
  constexpr std::size_t kMostBytes = std::size_t{16} << 20;
  return core::readRegularFile(file, kMostBytes, core::ErrorKind::kIo);
} catch (const core::Error&) {
  return "";
}

/// Whether nothing of a user's is lost when the .srt is replaced: its digest stands in a .vtt of this program, or
/// its text stays the same.
bool isOwnSrt(const std::string& srt, const std::filesystem::path& vtt, const std::vector<Subtitle>& subtitles) {
  if (srt == srtText(subtitles)) return true;
  return output::isOwnFigure(vtt) &&
         textOf(vtt).find(std::string(kDigestOfSrt) + core::toHex(core::sha256(srt))) != std::string::npos;
}

}  // namespace

std::vector<Subtitle> subtitlesOf(const scene::Scene& scene, const FrameRange& frames) {
  const double begin_s = filmTime_s(frames.first, scene.time.fps),
               end_s = filmTime_s(frames.last + 1, scene.time.fps);
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
    text += fmt::format("{}\n{}\n\n", span(subtitle, '.'), escaped(subtitle.text));
  return output::marked(output::kVttMark, text);
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
  const std::string srt = textOf(subtitleFiles(film)[0]);
  return !srt.empty() && srt != srtText(subtitles);
}

void checkSubtitleFiles(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film, bool force) {
  const auto files = subtitleFiles(film);
  output::checkTarget(files[0], force || isOwnSrt(textOf(files[0]), files[1], subtitles));
  output::checkTarget(files[1], force);
}

void writeSubtitles(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film) {
  // The .srt is written first: if the run is killed between the two, the next one finds its own text there.
  const auto files = subtitleFiles(film);
  output::writeFileAtomically(files[0], srtText(subtitles));
  output::writeFileAtomically(files[1], vttText(subtitles));
}

}  // namespace poinsot::app
