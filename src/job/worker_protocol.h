// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.h"
#include "job/statistics.h"
#include "request/frame_plan.h"

/// Protocol between a render and its workers, one JSON object per line. The render sends segments, and closes the
/// stream if there are no more. Workers send reports.
namespace poinsot::job {

struct FrameDone {
  std::int64_t k = 0;
  bool reused = false;      ///< an identical frame existed already
  std::string pixels = {};  ///< pixelDigest() of the new frame, if requested
};
struct SegmentDone {
  request::FrameRange frames;
};
/// Report of the worker's spans of work since the previous SpansDone.
struct SpansDone {
  std::vector<core::Span> spans;
};
struct WorkerFinished {
  Statistics spent;
  std::string renderer = {};
  std::string driver = {};
};
struct WorkerFailed {
  core::ErrorKind kind = core::ErrorKind::kGraphics;
  std::string message;
  std::filesystem::path file = {};  ///< core::FileError::file(), if the error is of that type
  int code = 0;                     ///< core::FileError::code(), an errno
};
using WorkerReport = std::variant<FrameDone, SegmentDone, SpansDone, WorkerFinished, WorkerFailed>;

/// Conversion to and from lines without the newline. Reading throws core::Error(kGraphics) if a line is incomplete
/// or of another type than expected.
std::string toLine(const request::FrameRange& segment);
std::string toLine(const WorkerReport& report);
request::FrameRange segmentFromLine(std::string_view line);
WorkerReport reportFromLine(std::string_view line);

}  // namespace poinsot::job
