// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output/film.h"
#include "request/frame_plan.h"
#include "request/output_target.h"
#include "request/subtitles.h"

namespace poinsot::job {

/// What a render leaves in its work folder about itself: enough for others to tell how far it is, and to finish it
/// without the scene.
struct JobRecord {
  std::string digest;    ///< jobDigest()
  std::string scene;     ///< sceneDigest()
  std::string settings;  ///< renderSettings()
  request::OutputKind kind = request::OutputKind::kFilm;
  output::FilmTrack film;  ///< of a film
  request::FrameRange frames;
  std::int64_t segmentFrames = request::kSegmentFrames;
  int shards = 1;
  std::string title, description;  ///< of the film
  std::vector<request::Subtitle> subtitles;
  std::vector<scene::InputFile> inputs;  ///< files that the scene names

  std::vector<request::FrameRange> segments() const { return request::segmentsOf(frames, segmentFrames); }
};

/// Frames that a job in a work folder may have: far more than a scene's, and few enough to go through them.
inline constexpr std::int64_t kMostJobFrames = 1'000'000;

/// @throws core::Error(kIo).
void writeJobRecord(const std::filesystem::path& workFolder, const JobRecord& job);

/// What writeJobRecord() wrote for this target. Nothing where it cannot be understood, is of another kind of
/// output, or has frames or shards beyond the limits: a work folder may come from anyone.
std::optional<JobRecord> parseJobRecord(std::string_view text, const request::OutputTarget& target);
/// Likewise of a work folder; nothing where there is none, too.
std::optional<JobRecord> readJobRecord(const std::filesystem::path& workFolder,
                                       const request::OutputTarget& target);

/// File of a film's segment in the work folder.
std::filesystem::path segmentFile(const std::filesystem::path& workFolder, output::FilmContainer container,
                                  const request::FrameRange& segment);

/// The files of a segment, whether they are there or not: a piece of film in the work folder, or the frames under
/// their final names.
std::vector<std::filesystem::path> segmentFiles(const std::filesystem::path& workFolder,
                                                const request::OutputTarget& target,
                                                const request::FrameRange& segment);

}  // namespace poinsot::job
