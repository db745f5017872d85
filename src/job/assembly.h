// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "core/file_batch.h"
#include "job/job_record.h"
#include "job/segment_record.h"

namespace poinsot::job {

/// Progress of a render: its segments in frame order, each with its state.
struct JobStatus {
  std::vector<request::FrameRange> segments;
  std::vector<SegmentState> states;

  bool complete() const;
  std::vector<request::FrameRange> in(SegmentState state) const;
};

/// Reads the records in the work folder and checks the files of each segment.
/// @param output  the render's target, which determines the names of the files
JobStatus statusOf(const std::filesystem::path& workFolder, const JobRecord& job,
                   const request::OutputTarget& output);

/// Returns the frames of segments as text, adjacent segments joined: "0-29, 60-89 and 12 more".
/// @param most  how many ranges the text lists
std::string framesText(const std::vector<request::FrameRange>& segments, std::size_t most = 8);

/// Compares every byte of the film `target` with the digest in its metadata. Returns kOther if `target` is not a
/// film of this job, and for a sequence.
output::FilmState filmState(const JobRecord& job, const std::filesystem::path& target);

/// Returns whether `target` is a film of this job and unchanged since it was written.
bool isFinished(const JobRecord& job, const std::filesystem::path& target);

/// Joins the segments of a job and adds the film to a batch, with its metadata and its subtitle file. Adds nothing
/// for a sequence, whose frames already have their final names.
/// @param output  the target that the render was started with
/// @param target  name of the film, which may differ from that of `output`
/// @throws core::Error(kIo) if frames are missing, stale or corrupt, with their numbers, or if writing fails
void assemble(core::FileBatch& batch, const std::filesystem::path& workFolder, const JobRecord& job,
              const request::OutputTarget& output, const std::filesystem::path& target);

}  // namespace poinsot::job
