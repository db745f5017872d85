// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/frame_plan.h"
#include "scene/scene.h"

/// A film's captions as files beside it, for players and for those who search or read them.
namespace poinsot::app {

/// Times from the film's first frame, in whole milliseconds: the formats have no finer ones.
struct Subtitle {
  std::int64_t from_ms = 0, to_ms = 0;
  std::string text;  ///< UTF-8 without TeX
};

/// The captions of a film of these frames: those of the scene that it shows, as far as it shows them.
std::vector<Subtitle> subtitlesOf(const scene::Scene& scene, const FrameRange& frames);

/// SubRip.
std::string srtText(const std::vector<Subtitle>& subtitles);
/// WebVTT. Its comments say that this program wrote it, and have the SHA-256 of srtText(): SubRip has no comments.
std::string vttText(const std::vector<Subtitle>& subtitles);

/// NAME.srt and NAME.vtt of NAME.mp4.
std::vector<std::filesystem::path> subtitleFiles(const std::filesystem::path& film);

/// Films that this program wrote beside `film` and that have the same subtitle files: NAME.gif of NAME.mp4.
std::vector<std::filesystem::path> filmsWithSubtitlesOf(const std::filesystem::path& film);

/// Whether a NAME.srt with other captions, or with other times, is there.
bool replacesOthers(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film);

/// As output::checkTarget(). Files that this program wrote, for a film of any format, and that nobody changed
/// since are replaced. @throws core::Error(kIo)
void checkSubtitleFiles(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film, bool force);

/// Writes both, each complete or not at all. @throws core::Error(kIo)
void writeSubtitles(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film);

}  // namespace poinsot::app
