// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/frame_plan.h"
#include "app/output_target.h"
#include "app/subtitles.h"
#include "output/film.h"

namespace poinsot::app {

/// What a render leaves in its work folder about itself: enough for others to tell how far it is, and to finish it
/// without the scene.
struct JobFile {
  std::string job;       ///< jobDigest()
  std::string scene;     ///< sceneDigest()
  std::string settings;  ///< renderSettings()
  OutputKind kind = OutputKind::kFilm;
  output::FilmTrack film;  ///< of a film
  FrameRange frames;
  std::int64_t segmentFrames = kSegmentFrames;
  int shards = 1;
  std::string title, description;  ///< of the film
  std::vector<Subtitle> subtitles;
  std::vector<scene::InputFile> inputs;  ///< files that the scene names

  std::vector<FrameRange> segments() const { return segmentsOf(frames, segmentFrames); }
};

/// @throws core::Error(kIo).
void writeJobFile(const std::filesystem::path& workFolder, const JobFile& job);

/// Nothing where there is none or it cannot be understood.
std::optional<JobFile> readJobFile(const std::filesystem::path& workFolder);

/// File of a film's segment in the work folder.
std::filesystem::path segmentFile(const std::filesystem::path& workFolder, output::FilmContainer container,
                                  const FrameRange& segment);

/// The files of a segment, whether they are there or not: a piece of film in the work folder, or the frames under
/// their final names.
std::vector<std::filesystem::path> segmentFiles(const std::filesystem::path& workFolder,
                                                const OutputTarget& target, const FrameRange& segment);

}  // namespace poinsot::app
