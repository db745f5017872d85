// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "job/frame_source.h"
#include "job/segment_record.h"
#include "job/worker_task.h"

namespace poinsot::job {

/// What a worker knows of the segments of its render, whoever made them, and tells of its own.
class SegmentKeeper {
 public:
  /// `renderer`: GL_RENDERER of this process.
  SegmentKeeper(const WorkerTask& task, std::string renderer);

  /// Whether the segment is there, as it would be made now: by the same job, or by another of the same pictures.
  bool has(const request::FrameRange& segment, FrameSource& source) const;
  /// Takes down that the segment is complete. @throws core::Error(kIo).
  void keep(const request::FrameRange& segment, std::vector<std::string> digests) const;

 private:
  request::OutputTarget target_;
  std::filesystem::path workFolder_;
  SegmentRecords records_;
  bool resume_;
  std::string jobDigest_, renderer_;
};

}  // namespace poinsot::job
