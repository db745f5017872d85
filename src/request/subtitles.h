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

/// Subtitle files of a film. Players show them, and people can read or search the captions in them.
namespace poinsot::request {

/// Caption with times in milliseconds, counted from the first frame of the film. Times are whole numbers, because
/// the file formats allow no fractions.
struct Subtitle {
  std::int64_t from_ms = 0, to_ms = 0;
  std::string text;
};

/// Returns the captions that the frames show, as text without TeX. Times are limited to the range of the frames.
std::vector<Subtitle> subtitlesOf(const scene::Scene& scene, const FrameRange& frames);

std::string srtText(const std::vector<Subtitle>& subtitles);
/// Formats subtitles as WebVTT. Comments in the text mark the file as written by this program and contain the
/// SHA-256 digest of srtText(). The .srt file itself cannot contain them, because SubRip has no comments.
std::string vttText(const std::vector<Subtitle>& subtitles);

/// Returns the names of the subtitle files, such as NAME.srt and NAME.vtt for NAME.mp4, in that order.
std::vector<std::filesystem::path> subtitleFiles(const std::filesystem::path& film);

/// Returns other films that this program wrote and that have the same subtitle files, such as NAME.gif for
/// NAME.mp4.
std::vector<std::filesystem::path> filmsWithSubtitlesOf(const std::filesystem::path& film);

/// Returns whether the film already has an .srt file whose captions or times differ from `subtitles`.
bool replacesOthers(const std::vector<Subtitle>& subtitles, const std::filesystem::path& film);

/// Registers both subtitle files as outputs of the run. Does nothing if there are no subtitles. Existing files may
/// be replaced if this program wrote them for any film and nobody has changed them since.
/// @throws the errors of output::RunFiles::writes()
void enterSubtitles(output::RunFiles& files, const std::vector<Subtitle>& subtitles,
                    const std::filesystem::path& film);

/// Adds both subtitle files to a batch, as companions of the film that was added last. If there are no subtitles,
/// removes the files that this program wrote for an earlier film with this name, unless another film uses them.
/// @param temporaryFolder  as for output::AtomicFile
/// @throws core::Error(kIo)
void addSubtitles(core::FileBatch& batch, const std::vector<Subtitle>& subtitles,
                  const std::filesystem::path& film, const std::filesystem::path& temporaryFolder);

/// Adds both subtitle files to a batch. The film is already finished and does not change.
/// @throws core::Error(kIo)
void addSubtitlesOfFinished(core::FileBatch& batch, const std::vector<Subtitle>& subtitles,
                            const std::filesystem::path& film);

/// Returns the subtitle files of a film that this program wrote and that nobody has changed since.
std::vector<std::filesystem::path> ownSubtitleFiles(const std::filesystem::path& film);

}  // namespace poinsot::request
