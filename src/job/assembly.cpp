// SPDX-License-Identifier: Apache-2.0
#include "job/assembly.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/text.h"
#include "job/work_left.h"
#include "output/film.h"

namespace poinsot::job {
namespace {

using std::filesystem::path;

std::vector<request::FrameRange> joined(const std::vector<request::FrameRange>& segments) {
  std::vector<request::FrameRange> ranges;
  for (const request::FrameRange& segment : segments)
    if (!ranges.empty() && ranges.back().last + 1 == segment.first)
      ranges.back().last = segment.last;
    else
      ranges.push_back(segment);
  return ranges;
}

/// Returns the text that identifies the film of a job in the film's metadata. No two jobs have the same text.
std::string originText(const JobRecord& job) {
  return fmt::format("frames {}-{} of scene sha256 {}; job sha256 {}; ", job.frames.first, job.frames.last,
                     job.scene, job.digest);
}

std::string gapsText(const JobStatus& status) {
  std::string text;
  const auto add = [&](SegmentState state, const char* word) {
    const auto segments = status.in(state);
    if (!segments.empty())
      text += fmt::format("{}frames {} are {}", text.empty() ? "" : "; ", framesText(segments), word);
  };
  add(SegmentState::kMissing, "missing");
  add(SegmentState::kStale, "from another scene or other settings");
  add(SegmentState::kCorrupt, "damaged");
  return text;
}

}  // namespace

bool JobStatus::complete() const {
  return std::ranges::all_of(states, [](SegmentState state) { return state == SegmentState::kDone; });
}

std::vector<request::FrameRange> JobStatus::in(SegmentState state) const {
  std::vector<request::FrameRange> those;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (states[i] == state) those.push_back(segments[i]);
  return those;
}

JobStatus statusOf(const path& workFolder, const JobRecord& job, const request::OutputTarget& output) {
  JobStatus status{job.segments(), {}};
  const SegmentRecords records(workFolder, output);
  for (const request::FrameRange& segment : status.segments)
    status.states.push_back(records.stateOf(segment, job.digest));
  return status;
}

std::string framesText(const std::vector<request::FrameRange>& segments, std::size_t most) {
  const std::vector<request::FrameRange> ranges = joined(segments);
  std::string text;
  for (std::size_t i = 0; i < std::min(ranges.size(), most); ++i)
    text += fmt::format("{}{}-{}", i == 0 ? "" : ", ", ranges[i].first, ranges[i].last);
  if (ranges.size() > most) text += fmt::format(" and {} more", ranges.size() - most);
  return text;
}

output::FilmState filmState(const JobRecord& job, const path& target) {
  return job.kind == request::OutputKind::kFilm ? output::filmState(target, originText(job))
                                                : output::FilmState::kOther;
}

bool isFinished(const JobRecord& job, const path& target) {
  return filmState(job, target) == output::FilmState::kWhole;
}

void assemble(core::FileBatch& batch, const path& workFolder, const JobRecord& job,
              const request::OutputTarget& output, const path& target) {
  const JobStatus status = statusOf(workFolder, job, output);
  if (!status.complete())
    throw core::ioError(
        fmt::format("{}: {}; {}", core::printable(target.native()), gapsText(status),
                    isFinished(job, output.path) ? "the film itself is complete" : makeText(job, status, output)));
  if (job.kind != request::OutputKind::kFilm) return;
  std::vector<path> files;
  for (const request::FrameRange& segment : status.segments)
    files.push_back(segmentFile(workFolder, job.film.container, segment));
  const auto first = SegmentRecords(workFolder, output).find(status.segments.front());
  const bool beside = core::folderOf(target) == core::folderOf(workFolder);  // other folders: maybe another disk
  const path temporaryFolder = beside ? workFolder : path();
  const output::FilmTexts texts{job.title, job.description, originText(job), first->renderer};
  batch.add(output::joinedSegments(files, target, job.film, texts, temporaryFolder));
  request::addSubtitles(batch, job.subtitles, target, temporaryFolder);
}

}  // namespace poinsot::job
