// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "core/file_batch.h"
#include "job/job_record.h"
#include "job/segment_record.h"

namespace poinsot::job {

/// How far a render is: the state of each segment, in order.
struct JobStatus {
  std::vector<request::FrameRange> segments;
  std::vector<SegmentState> states;

  bool complete() const;
  /// Segments in that state.
  std::vector<request::FrameRange> in(SegmentState state) const;
};

/// `output`: what the render was told to make.
JobStatus statusOf(const std::filesystem::path& workFolder, const JobRecord& job,
                   const request::OutputTarget& output);

/// "0-29, 60-89 and 12 more": frames of segments, neighbours joined, at most so many ranges.
std::string framesText(const std::vector<request::FrameRange>& segments, std::size_t most = 8);

/// Compares every byte of the film under its final name with the digest that it keeps; kOther for a sequence.
output::FilmState filmState(const JobRecord& job, const std::filesystem::path& target);

/// Whether the film stands under its final name already, byte for byte as it was written, and of this job.
bool isFinished(const JobRecord& job, const std::filesystem::path& target);

/// Adds to a batch what a job's segments make: a film, joined, with its texts and its subtitles, for the output's
/// name or another. The frames of a sequence have their names already.
/// @throws core::Error(kIo) naming the frames that are missing, stale or corrupt; or what cannot be written.
void assemble(core::FileBatch& batch, const std::filesystem::path& workFolder, const JobRecord& job,
              const request::OutputTarget& output, const std::filesystem::path& target);

}  // namespace poinsot::job
