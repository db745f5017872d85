// SPDX-License-Identifier: Apache-2.0
#include "app/job_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/regular_file.h"
#include "output/atomic_file.h"
#include "output/frame_pattern.h"

namespace poinsot::app {
namespace {

using Json = nlohmann::ordered_json;
using std::filesystem::path;

constexpr std::size_t kMostBytes = std::size_t{16} << 20;

path fileIn(const path& workFolder) { return workFolder / "job.json"; }

Json toJson(const std::vector<Subtitle>& subtitles) {
  Json all = Json::array();
  for (const Subtitle& s : subtitles) all.push_back({s.from_ms, s.to_ms, s.text});
  return all;
}

std::vector<Subtitle> subtitlesOf(const Json& json) {
  std::vector<Subtitle> subtitles;
  for (const Json& s : json)
    subtitles.push_back({s.at(0).get<std::int64_t>(), s.at(1).get<std::int64_t>(), s.at(2).get<std::string>()});
  return subtitles;
}

/// @throws core::Error for what this version does not write.
output::FilmTrack filmOf(const Json& json) {
  const auto container = output::filmContainer("film." + json.at("container").get<std::string>());
  const auto fps = core::parseRational(json.at("fps").get<std::string>());
  if (!container || !fps) throw core::Error(core::ErrorKind::kIo, "no film of this version");
  return {*container, *fps};
}

}  // namespace

void writeJobFile(const path& workFolder, const JobFile& job) {
  const Json json{{"job", job.job},
                  {"scene", job.scene},
                  {"settings", job.settings},
                  {"kind", static_cast<int>(job.kind)},
                  {"fps", core::toString(job.film.fps)},
                  {"container", output::nameOf(job.film.container)},
                  {"frames", {job.frames.first, job.frames.last}},
                  {"segment_frames", job.segmentFrames},
                  {"shards", job.shards},
                  {"title", job.title},
                  {"description", job.description},
                  {"subtitles", toJson(job.subtitles)}};
  const std::string text = json.dump(1) + "\n";
  output::writeFileAtomically(fileIn(workFolder), text);
}

std::optional<JobFile> readJobFile(const path& workFolder) try {
  const Json json = Json::parse(core::readRegularFile(fileIn(workFolder), kMostBytes, core::ErrorKind::kIo));
  JobFile job;
  job.job = json.at("job").get<std::string>();
  job.scene = json.at("scene").get<std::string>();
  job.settings = json.at("settings").get<std::string>();
  job.kind = static_cast<OutputKind>(json.at("kind").get<int>());
  if (job.kind == OutputKind::kFilm) job.film = filmOf(json);
  job.frames = {json.at("frames").at(0).get<std::int64_t>(), json.at("frames").at(1).get<std::int64_t>()};
  job.segmentFrames = json.at("segment_frames").get<std::int64_t>();
  job.shards = json.at("shards").get<int>();
  job.title = json.at("title").get<std::string>();
  job.description = json.at("description").get<std::string>();
  job.subtitles = subtitlesOf(json.at("subtitles"));
  const bool sound =
      job.frames.first >= 0 && job.frames.last >= job.frames.first && job.segmentFrames > 0 && job.shards > 0;
  return sound ? std::optional(job) : std::nullopt;
} catch (const core::Error&) {
  return std::nullopt;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

path segmentFile(const path& workFolder, output::FilmContainer container, const FrameRange& segment) {
  const std::string_view extension = output::isMadeWhole(container) ? "mkv" : output::nameOf(container);
  return workFolder / fmt::format("segment-{:09}-{:09}.{}", segment.first, segment.last, extension);
}

std::vector<path> segmentFiles(const path& workFolder, const OutputTarget& target, const FrameRange& segment) {
  if (target.kind == OutputKind::kFilm)
    return {segmentFile(workFolder, *output::filmContainer(target.path), segment)};
  const output::FramePattern pattern(target.path.string());
  std::vector<path> files;
  for (std::int64_t k = segment.first; k <= segment.last; ++k) files.push_back(pattern.path(k));
  return files;
}

}  // namespace poinsot::app
