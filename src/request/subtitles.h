// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/file_batch.h"
#include "output/run_files.h"
#include "request/frame_plan.h"
#include "scene/scene.h"

/// A film's captions as files beside it, for players and for those who search or read them.
namespace poinsot::request {

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

/// Enters both files as outputs. Files that this program wrote for a film of any format may be replaced, unless
/// somebody changed them since. Without subtitles there is nothing to enter.
/// @throws as output::RunFiles::writes()
void enterSubtitles(output::RunFiles& files, const std::vector<Subtitle>& subtitles,
                    const std::filesystem::path& film);

/// Adds both files to a batch, beside the film that was just added to it. Without subtitles those that this
/// program wrote for an earlier film of this name are removed, unless another film shares them.
/// @param temporaryFolder  as of output::AtomicFile
/// @throws core::Error(kIo)
void addSubtitles(core::FileBatch& batch, const std::vector<Subtitle>& subtitles,
                  const std::filesystem::path& film, const std::filesystem::path& temporaryFolder);

/// Adds both files to a batch for a film that stays as it is. @throws core::Error(kIo)
void addSubtitlesOfFinished(core::FileBatch& batch, const std::vector<Subtitle>& subtitles,
                            const std::filesystem::path& film);

/// Returns those of a film's subtitle files that this program wrote and nobody changed.
std::vector<std::filesystem::path> ownSubtitleFiles(const std::filesystem::path& film);

}  // namespace poinsot::request
