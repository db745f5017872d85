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

/// Description of a render, stored as job.json in its work folder. With this record, other processes can report
/// progress and join the segments without loading the scene.
struct JobRecord {
  std::string digest;    ///< result of jobDigest()
  std::string scene;     ///< result of sceneDigest()
  std::string settings;  ///< result of renderSettings()
  request::OutputKind kind = request::OutputKind::kFilm;
  output::FilmTrack film;  ///< used only for films
  request::FrameRange frames;
  std::int64_t segmentFrames = request::kSegmentFrames;
  int shards = 1;
  std::string title, description;
  std::vector<request::Subtitle> subtitles;
  std::vector<scene::InputFile> inputs;  ///< files that the scene names; not stored in job.json

  std::vector<request::FrameRange> segments() const { return request::segmentsOf(frames, segmentFrames); }
};

/// Upper limit for the frame numbers of a job. Scenes stay far below it, and a loop up to it is still fast.
inline constexpr std::int64_t kMostJobFrames = 1'000'000;

/// Writes job.json into the work folder. @throws core::Error(kIo).
void writeJobRecord(const std::filesystem::path& workFolder, const JobRecord& job);

/// Parses the text of a job.json file from an untrusted source.
/// @returns nullopt if the text is malformed, does not match the kind of `target`, or has too many frames or
/// shards
std::optional<JobRecord> parseJobRecord(std::string_view text, const request::OutputTarget& target);
/// Reads and parses job.json in the work folder. Returns nullopt if the file is missing or invalid.
std::optional<JobRecord> readJobRecord(const std::filesystem::path& workFolder,
                                       const request::OutputTarget& target);

std::filesystem::path segmentFile(const std::filesystem::path& workFolder, output::FilmContainer container,
                                  const request::FrameRange& segment);

/// Returns the paths of a segment's files, whether or not they exist: one piece of a film in the work folder, or
/// the frames of a sequence under their final names.
std::vector<std::filesystem::path> segmentFiles(const std::filesystem::path& workFolder,
                                                const request::OutputTarget& target,
                                                const request::FrameRange& segment);

}  // namespace poinsot::job
