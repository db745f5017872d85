// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "job/job_record.h"
#include "request/output_target.h"

namespace poinsot::job {

/// Sends segments on to standard output, in their order, and removes them: pictures one after the other, or an MP4
/// in pieces.
class SegmentStream {
 public:
  SegmentStream(const request::OutputTarget& target, const JobRecord& job, std::filesystem::path workFolder);

  /// A segment that is complete, in whatever order they become so; what is next is sent.
  /// @throws core::Error(kIo); core::BrokenPipe; Interrupted, also while the reader does not read.
  void add(const request::FrameRange& segment);
  /// After the last one: all is with the reader or, of a file, on disk.
  void finish();

 private:
  void send(const request::FrameRange& segment);
  void sendFile(const std::filesystem::path& file) const;

  request::OutputTarget target_;
  std::filesystem::path workFolder_;
  std::optional<output::FilmStream> film_;
  std::vector<request::FrameRange> ready_;  // not sent yet
  std::int64_t next_;                       // frame
};

}  // namespace poinsot::job
