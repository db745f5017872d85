// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.h"
#include "gl/offscreen_context.h"
#include "job/statistics.h"
#include "request/frame_plan.h"
#include "request/output_target.h"
#include "request/picture_form.h"
#include "request/scene_request.h"

/// What a render and its workers say to each other: one JSON object a line. To the worker first its job, then
/// segments; the end of the stream means there are no more. From the worker reports.
namespace poinsot::job {

/// What a worker needs to know for life.
struct WorkerJob {
  request::SceneRequest scene;
  request::OutputTarget target;
  request::FrameRange frames;        ///< all that are made
  std::optional<double> time_s;      ///< film time of the one frame, in place of its own
  std::filesystem::path workFolder;  ///< takes the segments of a film
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = false;
  int rasterThreads = 0;  ///< llvmpipe's; 0 rasterises in the worker itself
  request::PictureForm form = {};
  std::int64_t segmentFrames = request::kSegmentFrames;
  bool resume = false;         ///< what is there and is the same is not made again
  std::string job = {};        ///< jobDigest() of a film or a sequence, of the scene as the render read it
  bool trace = false;          ///< reports spans
  double expected_bytes = 0;   ///< of memory (memory.h)
  bool digestsPixels = false;  ///< reports the pixelDigest() of each frame
};

struct FrameDone {
  std::int64_t k = 0;
  bool reused = false;      ///< it was there, and is what would have been made
  std::string pixels = {};  ///< pixelDigest() of what was drawn, where the job asks for it
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
std::string toLine(const WorkerJob& job);
std::string toLine(const request::FrameRange& segment);
std::string toLine(const WorkerReport& report);
WorkerJob jobFromLine(std::string_view line);
request::FrameRange segmentFromLine(std::string_view line);
WorkerReport reportFromLine(std::string_view line);

}  // namespace poinsot::job
