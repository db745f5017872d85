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
/// Returns WebVTT. Its comments are the mark of this program and the SHA-256 of srtText(), as SubRip has no
/// comments.
std::string vttText(const std::vector<Subtitle>& subtitles);

/// NAME.srt and NAME.vtt of NAME.mp4.
std::vector<std::filesystem::path> subtitleFiles(const std::filesystem::path& film);

/// Returns the films that this program wrote beside `film` and that share its subtitle files: NAME.gif for
/// NAME.mp4.
std::vector<std::filesystem::path> filmsWithSubtitlesOf(const std::filesystem::path& film);

/// Whether a NAME.srt exists whose captions or times differ from `subtitles`.
bool replacesOthers(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film);

/// Checks both files like output::checkTarget(). Files that this program wrote for a film of any format may be
/// replaced, unless somebody changed them since.
/// @throws core::Error(kIo)
void checkSubtitleFiles(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film, bool force);

/// Writes both, each complete or not at all. @throws core::Error(kIo)
void writeSubtitles(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film);

}  // namespace poinsot::app
