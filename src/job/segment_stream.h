// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "job/job_record.h"
#include "request/output_target.h"

namespace poinsot::job {

/// Writer of finished segments to standard output, in frame order. Writes PNG pictures one after the other, or a
/// fragmented MP4. Removes the file of each written segment.
class SegmentStream {
 public:
  SegmentStream(const request::OutputTarget& target, const JobRecord& job, std::filesystem::path workFolder);

  /// Accepts a finished segment. Segments may finish in any order, but are written in frame order.
  /// @throws core::Error(kIo) if writing fails, or if a signal arrives while the reader blocks; core::BrokenPipe
  void add(const request::FrameRange& segment);
  /// Ends the output after the last segment. If standard output is a file, syncs the file.
  void finish();

 private:
  void send(const request::FrameRange& segment);
  void sendFile(const std::filesystem::path& file) const;

  request::OutputTarget target_;
  std::filesystem::path workFolder_;
  std::optional<output::FilmStream> film_;
  std::vector<request::FrameRange> ready_;
  std::int64_t next_;  // first frame that is not written yet
};

}  // namespace poinsot::job
