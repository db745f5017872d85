// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "job/job_record.h"
#include "request/output_target.h"

namespace poinsot::job {

/// Writes segments to standard output in frame order and removes them: PNG pictures one after the other, or an MP4
/// in fragments.
class SegmentStream {
 public:
  SegmentStream(const request::OutputTarget& target, const JobRecord& job, std::filesystem::path workFolder);

  /// Accepts a finished segment. Segments may finish in any order; output is written in frame order.
  /// @throws core::Error(kIo), also if a signal arrives while the reader does not read; core::BrokenPipe
  void add(const request::FrameRange& segment);
  /// Ends the output after the last segment. If standard output is a file, the file is then synced to disk.
  void finish();

 private:
  void send(const request::FrameRange& segment);
  void sendFile(const std::filesystem::path& file) const;

  request::OutputTarget target_;
  std::filesystem::path workFolder_;
  std::optional<output::FilmStream> film_;
  std::vector<request::FrameRange> ready_;
  std::int64_t next_;  // first frame that is not sent yet
};

}  // namespace poinsot::job
