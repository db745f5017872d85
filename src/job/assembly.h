// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "core/file_batch.h"
#include "job/job_record.h"
#include "job/segment_record.h"

namespace poinsot::job {

/// Progress of a render: the segments in frame order, and the state of each segment.
struct JobStatus {
  std::vector<request::FrameRange> segments;
  std::vector<SegmentState> states;

  bool complete() const;
  std::vector<request::FrameRange> in(SegmentState state) const;
};

/// Reads the records in the work folder and checks the files of each segment.
/// @param output  target of the render, which determines the file names
JobStatus statusOf(const std::filesystem::path& workFolder, const JobRecord& job,
                   const request::OutputTarget& output);

/// Returns the frame ranges of the segments as text, such as "0-29, 60-89 and 12 more". Adjacent segments become
/// one range.
/// @param most  number of ranges to list
std::string framesText(const std::vector<request::FrameRange>& segments, std::size_t most = 8);

/// Checks every byte of the film `target` against the digest in its metadata. Returns kOther if `target` is a
/// sequence or not a film of this job.
output::FilmState filmState(const JobRecord& job, const std::filesystem::path& target);

/// Returns whether `target` is a film of this job and unchanged since it was written.
bool isFinished(const JobRecord& job, const std::filesystem::path& target);

/// Joins the segments of a job and adds the film to a batch, with its metadata and its subtitle file. For a
/// sequence, adds nothing, because the frames already have their final names.
/// @param output  target that the render was started with
/// @param target  path of the film, which may differ from the path of `output`
/// @throws core::Error(kIo) with the frame numbers if frames are missing, stale or corrupt, or if writing fails
void assemble(core::FileBatch& batch, const std::filesystem::path& workFolder, const JobRecord& job,
              const request::OutputTarget& output, const std::filesystem::path& target);

}  // namespace poinsot::job
