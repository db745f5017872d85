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

/// Subtitle files beside a film, for players and for people who search or read the captions.
namespace poinsot::request {

/// Caption with its times from the film's first frame, in whole milliseconds: the formats have no finer unit.
struct Subtitle {
  std::int64_t from_ms = 0, to_ms = 0;
  std::string text;
};

/// Returns the captions that appear in `frames`, cut to that range, as text without TeX.
std::vector<Subtitle> subtitlesOf(const scene::Scene& scene, const FrameRange& frames);

std::string srtText(const std::vector<Subtitle>& subtitles);
/// Serialises subtitles as WebVTT. Comments hold this program's mark and the SHA-256 of srtText(), because SubRip
/// has no comments.
std::string vttText(const std::vector<Subtitle>& subtitles);

/// Returns NAME.srt and NAME.vtt for NAME.mp4, in that order.
std::vector<std::filesystem::path> subtitleFiles(const std::filesystem::path& film);

/// Returns the films that this program wrote beside `film` and that share its subtitle files, such as NAME.gif for
/// NAME.mp4.
std::vector<std::filesystem::path> filmsWithSubtitlesOf(const std::filesystem::path& film);

/// Returns whether a NAME.srt exists whose captions or times differ from `subtitles`.
bool replacesOthers(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film);

/// Enters both subtitle files as outputs of the run; enters nothing if there are no subtitles. Files that this
/// program wrote for a film of any format may be replaced, unless somebody has changed them since.
/// @throws as output::RunFiles::writes()
void enterSubtitles(output::RunFiles& files, const std::vector<Subtitle>& subtitles,
                    const std::filesystem::path& film);

/// Adds both subtitle files to a batch, beside the film that was added last. If there are no subtitles, removes
/// the files that this program wrote for an earlier film of this name, unless another film shares them.
/// @param temporaryFolder  as for output::AtomicFile
/// @throws core::Error(kIo)
void addSubtitles(core::FileBatch& batch, const std::vector<Subtitle>& subtitles,
                  const std::filesystem::path& film, const std::filesystem::path& temporaryFolder);

/// Adds both subtitle files to a batch for a finished film, which stays unchanged.
/// @throws core::Error(kIo)
void addSubtitlesOfFinished(core::FileBatch& batch, const std::vector<Subtitle>& subtitles,
                            const std::filesystem::path& film);

/// Returns the subtitle files of a film that this program wrote and nobody has changed.
std::vector<std::filesystem::path> ownSubtitleFiles(const std::filesystem::path& film);

}  // namespace poinsot::request
