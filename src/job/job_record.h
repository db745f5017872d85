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

/// Description of a render, kept as job.json in its work folder. With this record, other processes can report the
/// progress and join the segments without the scene.
struct JobRecord {
  std::string digest;    ///< jobDigest()
  std::string scene;     ///< sceneDigest()
  std::string settings;  ///< renderSettings()
  request::OutputKind kind = request::OutputKind::kFilm;
  output::FilmTrack film;  ///< only for films
  request::FrameRange frames;
  std::int64_t segmentFrames = request::kSegmentFrames;
  int shards = 1;
  std::string title, description;
  std::vector<request::Subtitle> subtitles;
  std::vector<scene::InputFile> inputs;  ///< files that the scene names; not stored in job.json

  std::vector<request::FrameRange> segments() const { return request::segmentsOf(frames, segmentFrames); }
};

/// Upper limit for the frame numbers of a job: far more than a scene has, yet few enough to iterate over.
inline constexpr std::int64_t kMostJobFrames = 1'000'000;

/// Writes job.json into the work folder. @throws core::Error(kIo).
void writeJobRecord(const std::filesystem::path& workFolder, const JobRecord& job);

/// Parses the text of a job.json file, which may come from anyone.
/// @returns nullopt if the text is malformed, does not match the kind of `target`, or has too many frames or
/// shards
std::optional<JobRecord> parseJobRecord(std::string_view text, const request::OutputTarget& target);
/// Reads and parses job.json in the work folder. Returns nullopt also if the file cannot be read.
std::optional<JobRecord> readJobRecord(const std::filesystem::path& workFolder,
                                       const request::OutputTarget& target);

std::filesystem::path segmentFile(const std::filesystem::path& workFolder, output::FilmContainer container,
                                  const request::FrameRange& segment);

/// Returns the paths of a segment's files, existing or not: one piece of film in the work folder, or the frames of
/// a sequence under their final names.
std::vector<std::filesystem::path> segmentFiles(const std::filesystem::path& workFolder,
                                                const request::OutputTarget& target,
                                                const request::FrameRange& segment);

}  // namespace poinsot::job
