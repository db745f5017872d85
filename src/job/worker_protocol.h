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

/// What a render and its workers say to each other: one JSON object a line. To the worker segments; the end of
/// the stream means there are no more. From the worker reports.
namespace poinsot::job {

struct FrameDone {
  std::int64_t k = 0;
  bool reused = false;      ///< it was there, and is what would have been made
  std::string pixels = {};  ///< pixelDigest() of what was drawn, where the render asks for it
};
/// Every file of the segment is complete under its name.
struct SegmentDone {
  request::FrameRange frames;
};
/// What it has done since the last such report.
struct SpansDone {
  std::vector<core::Span> spans;
};
struct WorkerFinished {
  Statistics spent;
  std::string renderer = {};  ///< GL_RENDERER
  std::string driver = {};    ///< gl::OffscreenContext::driver()
};
struct WorkerFailed {
  core::ErrorKind kind = core::ErrorKind::kGraphics;
  std::string message;
  std::filesystem::path file = {};  ///< of a core::FileError, as is
  int code = 0;                     ///< this errno
};
using WorkerReport = std::variant<FrameDone, SegmentDone, SpansDone, WorkerFinished, WorkerFailed>;

/// Lines, without their newline. Reading throws core::Error(kGraphics) for a line that was lost in part, or that
/// is another than the one expected.
std::string toLine(const request::FrameRange& segment);
std::string toLine(const WorkerReport& report);
request::FrameRange segmentFromLine(std::string_view line);
WorkerReport reportFromLine(std::string_view line);

}  // namespace poinsot::job
