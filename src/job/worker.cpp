// SPDX-License-Identifier: Apache-2.0
#include "job/worker.h"

#include <signal.h>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "core/file_error.h"
#include "image/pixel_digest.h"
#include "job/job_record.h"
#include "job/scene_frames.h"
#include "job/segment_sink.h"
#include "job/worker_heap.h"
#include "job/worker_protocol.h"
#include "process/interrupt.h"
#include "process/sandbox.h"

namespace poinsot::job {

namespace {

/// Sends a report to the main process. Throws Interrupted if the main process has ended.
void report(int reports, const WorkerReport& what) {
  if (!process::writeLine(reports, toLine(what))) throw process::Interrupted(SIGHUP);
}

void reportReused(const request::FrameRange& segment, int reports) {
  for (std::int64_t k = segment.first; k <= segment.last; ++k) report(reports, FrameDone{k, true});
}

void reportSpans(core::StepLedger& steps, int reports) {
  auto spans = steps.takeSpans();
  if (!spans.empty()) report(reports, SpansDone{std::move(spans)});
}

class SegmentMaker {
 public:
  SegmentMaker(int reports, FrameSource& source, core::StepLedger& steps, const SegmentKeeper* keeper,
               bool digestsPixels)
      : reports_(reports), source_(source), steps_(steps), keeper_(keeper), digestsPixels_(digestsPixels) {}

  void make(const request::FrameRange& segment, output::FrameSink& sink) {
    std::vector<std::string> digests;
    for (std::int64_t k = segment.first; k <= segment.last; ++k) {
      process::throwIfInterrupted();
      steps_.setFrame(k);
      if (keeper_) digests.push_back(core::toHex(source_.digest(k)));
      const bool there = sink.has(k);
      FrameDone done{k, there};
      if (!there) done.pixels = makeFrame(k, sink);
      reportSpans(steps_, reports_);
      report(reports_, done);
    }
    steps_.setFrame(std::nullopt);
    sink.finish();
    if (keeper_) keeper_->keep(segment, std::move(digests));
  }

  Statistics spent() const {
    Statistics spent;
    spent.frames = frames_;
    spent.workers = 1;
    spent.first_s = first_.sum_s();
    spent.steps = steps_.times();
    spent.steps -= first_;
    return spent;
  }

 private:
  std::string makeFrame(std::int64_t k, output::FrameSink& sink) {
    const image::Frame frame = source_.frame(k);
    if (frames_++ == 0) first_ = steps_.times();
    sink.write(frame, k);
    return digestsPixels_ ? image::pixelDigest(frame.picture) : "";
  }

  int reports_;
  FrameSource& source_;
  core::StepLedger& steps_;
  const SegmentKeeper* keeper_;
  bool digestsPixels_;
  core::StepTimes first_;
  std::int64_t frames_ = 0;
};

void work(const WorkerTask& task, process::LineReader& segments, int reports) {
  process::forbidProcessesInSandbox();
  const RenderRequest& render = task.render;
  gl::pinEnvironment(render.reproducible, task.rasterThreads);
  unsetenv("HOME");  // hides ~/.drirc, which could change the OpenGL driver; HOME is not needed later
  beginHeap(render.worker_bytes);
  const auto context = gl::openContext(render.backend);
  core::StepLedger steps;
  if (render.trace) steps.trace();
  SceneFrames frames(render, *context, &steps);
  const SegmentKeeper keeper(task, context->renderer());
  Statistics spent = makeSegments(segments, reports, frames, sinkMaker(task, frames, steps), steps,
                                  render.record ? &keeper : nullptr, render.digestsPixels);
  spent.cpu_s = core::processCpu_s();
  spent.peakMemory_bytes = processPeakMemory_bytes();
  report(reports, WorkerFinished{spent, context->renderer(), context->driver()});
}

int failed(int reports, const WorkerFailed& failure) {
  process::writeLine(reports, toLine(failure));
  return EXIT_FAILURE;
}

/// Does the work of the process and reports errors to the main process. @throws std::bad_alloc
int workTellingFailures(const WorkerTask& task, int segments, int reports) {
  process::LineReader lines(segments);
  try {
    work(task, lines, reports);
    return EXIT_SUCCESS;
  } catch (const process::Interrupted& interrupted) {
    return 128 + interrupted.signal();
  } catch (const core::FileError& error) {
    return failed(reports, {error.kind(), error.what(), error.file(), error.code()});
  } catch (const core::Error& error) {
    return failed(reports, {error.kind(), error.what()});
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return failed(reports, {core::ErrorKind::kGraphics, error.what()});
  }
}

}  // namespace

Statistics makeSegments(process::LineReader& segments, int reports, FrameSource& source, const SinkMaker& sinkOf,
                        core::StepLedger& steps, const SegmentKeeper* keeper, bool digestsPixels) {
  SegmentMaker maker(reports, source, steps, keeper, digestsPixels);
  while (const auto line = segments.wait()) {
    const request::FrameRange segment = segmentFromLine(*line);
    const std::int64_t begin_ns = core::monotonic_ns();
    if (keeper && keeper->has(segment, source))
      reportReused(segment, reports);
    else
      maker.make(segment, *sinkOf(segment));
    steps.add({"segment", begin_ns, core::monotonic_ns(), segment.first});
    reportSpans(steps, reports);
    report(reports, SegmentDone{segment});
  }
  return maker.spent();
}

int runWorker(const WorkerTask& task, int segments, int reports) {
  process::watchInterruptsAsWorker();
  const std::string outOfMemory = toLine(WorkerFailed{core::ErrorKind::kGraphics, "out of memory"}) + '\n';
  try {
    return workTellingFailures(task, segments, reports);
  } catch (const std::bad_alloc&) {  // memory may have run out while another error was reported
    process::writeText(reports, outOfMemory);
    return EXIT_FAILURE;
  }
}

namespace {

bool samePictures(const SegmentRecord& record, FrameSource& source) {
  for (std::int64_t k = record.frames.first; k <= record.frames.last; ++k)
    if (record.digests[static_cast<std::size_t>(k - record.frames.first)] != core::toHex(source.digest(k)))
      return false;
  return true;
}

}  // namespace

SegmentKeeper::SegmentKeeper(const WorkerTask& task, std::string renderer)
    : target_(task.render.target),
      workFolder_(task.workFolder),
      records_(task.workFolder, task.render.target),
      resume_(task.resumes()),
      jobDigest_(task.render.record ? task.render.record->digest : ""),
      renderer_(std::move(renderer)) {}

bool SegmentKeeper::has(const request::FrameRange& segment, FrameSource& source) const {
  auto record = resume_ ? records_.find(segment) : std::nullopt;
  if (!record || !SegmentRecords::isWhole(*record)) return false;
  if (record->jobDigest == jobDigest_ && record->renderer == renderer_) return true;
  if (!samePictures(*record, source)) return false;
  record->jobDigest = jobDigest_;
  record->renderer = renderer_;
  records_.keep(*record);
  return true;
}

void SegmentKeeper::keep(const request::FrameRange& segment, std::vector<std::string> digests) const {
  SegmentRecord record{segment, jobDigest_, renderer_, std::move(digests), {}};
  for (const auto& file : segmentFiles(workFolder_, target_, segment)) record.files.push_back(recordOf(file));
  records_.keep(record);
}

}  // namespace poinsot::job
