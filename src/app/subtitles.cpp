// SPDX-License-Identifier: Apache-2.0
#include "app/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/frame_clock.h"
#include "output/atomic_file.h"
#include "output/film.h"
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

void write(const std::filesystem::path& file, const std::string& text) { output::writeFileAtomically(file, text); }

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
  std::string text = "WEBVTT\n\n";
  for (const Subtitle& subtitle : subtitles)
    text += fmt::format("{}\n{}\n\n", span(subtitle, '.'), escaped(subtitle.text));
  return text;
}

std::vector<std::filesystem::path> subtitleFiles(const std::filesystem::path& film) {
  std::filesystem::path srt = film, vtt = film;
  return {srt.replace_extension(".srt"), vtt.replace_extension(".vtt")};
}

void checkSubtitleFiles(const std::filesystem::path& film, bool force) {
  const bool ours = output::isOwnFilm(film);
  for (const std::filesystem::path& file : subtitleFiles(film)) output::checkTarget(file, force || ours);
}

void writeSubtitles(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film) {
  const auto files = subtitleFiles(film);
  write(files[0], srtText(subtitles));
  write(files[1], vttText(subtitles));
}

}  // namespace poinsot::app
