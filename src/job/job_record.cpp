// SPDX-License-Identifier: Apache-2.0
#include "job/job_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json.h"
#include "core/regular_file.h"
#include "output/frame_pattern.h"

namespace poinsot::job {
namespace {

using Json = nlohmann::ordered_json;
using std::filesystem::path;

path fileIn(const path& workFolder) { return workFolder / "job.json"; }

Json toJson(const std::vector<request::Subtitle>& subtitles) {
  Json all = Json::array();
  for (const request::Subtitle& s : subtitles) all.push_back({s.from_ms, s.to_ms, s.text});
  return all;
}

std::vector<request::Subtitle> subtitlesOf(const Json& json) {
  std::vector<request::Subtitle> subtitles;
  for (const Json& s : json)
    subtitles.push_back({core::wholeNumber(s.at(0)), core::wholeNumber(s.at(1)), s.at(2).get<std::string>()});
  return subtitles;
}

output::FilmTrack filmOf(const Json& json) {
  const auto container = output::filmContainer("film." + json.at("container").get<std::string>());
  const auto fps = core::parseRational(json.at("fps").get<std::string>());
  const std::int64_t colors = json.contains("colors") ? core::wholeNumber(json.at("colors")) : output::kMostColors;
  if (!container || !fps || colors < 2 || colors > output::kMostColors)
    throw core::ioError("no film of this version");
  return {*container, *fps, static_cast<int>(colors)};
}

bool isSound(const JobRecord& job) {
  const auto [first, last] = job.frames;
  return first >= 0 && last >= first && last < kMostJobFrames && job.segmentFrames > 0 &&
         job.segmentFrames <= kMostJobFrames;
}

}  // namespace

void writeJobRecord(const path& workFolder, const JobRecord& job) {
  const Json json{{"job", job.digest},
                  {"scene", job.scene},
                  {"settings", job.settings},
                  {"kind", static_cast<int>(job.kind)},
                  {"fps", core::toString(job.film.fps)},
                  {"container", output::nameOf(job.film.container)},
                  {"colors", job.film.colors},
                  {"frames", {job.frames.first, job.frames.last}},
                  {"segment_frames", job.segmentFrames},
                  {"shards", job.shards},
                  {"title", job.title},
                  {"description", job.description},
                  {"subtitles", toJson(job.subtitles)}};
  const std::string text = json.dump(1) + "\n";
  core::writeFileAtomically(fileIn(workFolder), text);
}

std::optional<JobRecord> parseJobRecord(std::string_view text, const request::OutputTarget& target) try {
  const Json json = core::parseJson(text);
  JobRecord job;
  job.digest = json.at("job").get<std::string>();
  job.scene = json.at("scene").get<std::string>();
  job.settings = json.at("settings").get<std::string>();
  job.kind = target.kind;
  if (job.kind == request::OutputKind::kFilm) job.film = filmOf(json);
  job.frames = {core::wholeNumber(json.at("frames").at(0)), core::wholeNumber(json.at("frames").at(1))};
  job.segmentFrames = core::wholeNumber(json.at("segment_frames"));
  const std::int64_t shards = core::wholeNumber(json.at("shards"));
  if (shards < 1 || shards > request::kMostShards) return std::nullopt;
  job.shards = static_cast<int>(shards);
  job.title = json.at("title").get<std::string>();
  job.description = json.at("description").get<std::string>();
  job.subtitles = subtitlesOf(json.at("subtitles"));
  const bool ofTarget =
      core::wholeNumber(json.at("kind")) == static_cast<int>(target.kind) &&
      (job.kind != request::OutputKind::kFilm || job.film.container == output::filmContainer(target.path));
  return ofTarget && isSound(job) ? std::optional(job) : std::nullopt;
} catch (const core::Error&) {
  return std::nullopt;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

std::optional<JobRecord> readJobRecord(const path& workFolder, const request::OutputTarget& target) try {
  return parseJobRecord(core::readRegularFile(fileIn(workFolder), core::kMostJsonBytes, core::ErrorKind::kIo),
                        target);
} catch (const core::Error&) {
  return std::nullopt;
}

path segmentFile(const path& workFolder, output::FilmContainer container, const request::FrameRange& segment) {
  const std::string_view extension = output::isMadeWhole(container) ? "mkv" : output::nameOf(container);
  return workFolder / fmt::format("segment-{:09}-{:09}.{}", segment.first, segment.last, extension);
}

std::vector<path> segmentFiles(const path& workFolder, const request::OutputTarget& target,
                               const request::FrameRange& segment) {
  if (target.kind == request::OutputKind::kFilm)
    return {segmentFile(workFolder, *output::filmContainer(target.path), segment)};
  const output::FramePattern pattern(target.path.string());
  std::vector<path> files;
  for (std::int64_t k = segment.first; k <= segment.last; ++k) files.push_back(pattern.path(k));
  return files;
}

}  // namespace poinsot::job
