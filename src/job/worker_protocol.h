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

/// Protocol between the main process of a render and its workers, with one JSON object per line. The main process
/// sends segments, and closes the stream after the last. Workers send reports.
namespace poinsot::job {

struct FrameDone {
  std::int64_t k = 0;
  bool reused = false;      ///< an identical frame existed before the render
  std::string pixels = {};  ///< pixelDigest() of the new frame, if requested
};
struct SegmentDone {
  request::FrameRange frames;
};
/// Report of the worker's time spans since its previous SpansDone.
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
  std::filesystem::path file = {};  ///< core::FileError::file() of a FileError; empty for other errors
  int code = 0;                     ///< core::FileError::code() of a FileError, an errno
};
using WorkerReport = std::variant<FrameDone, SegmentDone, SpansDone, WorkerFinished, WorkerFailed>;

/// Conversion to and from lines, without the newline. Reading throws core::Error(kGraphics) if a line is
/// incomplete or contains another type than expected.
std::string toLine(const request::FrameRange& segment);
std::string toLine(const WorkerReport& report);
request::FrameRange segmentFromLine(std::string_view line);
WorkerReport reportFromLine(std::string_view line);

}  // namespace poinsot::job
