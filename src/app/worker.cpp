// SPDX-License-Identifier: Apache-2.0
#include "app/worker.h"

#include <fmt/format.h>
#include <malloc.h>
#include <signal.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "app/interrupt.h"
#include "app/job_identity.h"
#include "app/scene_frames.h"
#include "app/segment_sink.h"
#include "app/worker_protocol.h"
#include "core/error.h"
#include "core/text.h"

namespace poinsot::app {
namespace {

/// The parent is gone when nobody reads the reports; then there is nothing left to do.
void report(int reports, const WorkerReport& what) {
  if (!writeLine(reports, toLine(what))) throw Interrupted(SIGHUP);
}

void reportReused(const FrameRange& segment, int reports) {
  for (std::int64_t k = segment.first; k <= segment.last; ++k) report(reports, FrameDone{k, true});
}

void makeFrame(std::int64_t k, FrameSource& source, output::FrameSink& sink, Statistics& spent) {
  const image::AnyImage picture = source.frame(k);
  if (spent.frames++ == 0) spent.making -= source.times();  // told apart from the other frames
  sink.write(picture, k);
}

void makeSegment(const FrameRange& segment, int reports, FrameSource& source, output::FrameSink& sink,
                 const SegmentKeeper* keeper, Statistics& spent) {
  std::vector<std::string> digests;
  for (std::int64_t k = segment.first; k <= segment.last; ++k) {
    throwIfInterrupted();
    if (keeper) digests.push_back(core::toHex(source.digest(k)));
    const bool there = sink.has(k);
    if (!there) makeFrame(k, source, sink, spent);
    report(reports, FrameDone{k, there});
  }
  sink.finish();
  if (keeper) keeper->keep(segment, std::move(digests));
}

/// Mesa reads its environment once, at the first context.
void pin(const WorkerJob& job) {
  setenv("LP_NUM_THREADS", fmt::format("{}", job.rasterThreads).c_str(), 1);
  gl::pinEnvironment(job.reproducible);
}

/// The scene's text came with the job; the files that it names are read again here.
void expectSameScene(const WorkerJob& job, const scene::Scene& scene, const std::string& settings) {
  if (job.job.empty() || core::toHex(jobDigest(sceneDigest(job.scene, scene), settings)) == job.job) return;
  throw core::Error(core::ErrorKind::kIo,
                    fmt::format("{}: a file that the scene names has changed since the render began",
                                core::printable(job.scene.fileName)));
}

void work(LineReader& jobs, int reports) {
  const auto line = jobs.wait();
  if (!line) return;
  const WorkerJob job = jobFromLine(*line);
  pin(job);
  const scene::Scene scene = loadRequested(job.scene);
  const std::string settings = renderSettings(job.target, job.form, job.reproducible, job.segmentFrames, scene);
  expectSameScene(job, scene, settings);
  const auto context = gl::openContext(job.backend);
  SceneFrames frames(scene, *context, job.time_s, job.form, output::figureMedium(job.target.path), settings);
  EncodingTimes encoding;
  const bool keeps = !job.job.empty();
  const SegmentKeeper keeper(job, context->renderer());
  Statistics spent =
      makeSegments(jobs, reports, frames, sinkMaker(job, scene, frames, encoding), keeps ? &keeper : nullptr);
  spent.convert_s = encoding.convert_s;
  spent.encode_s = encoding.encode_s;
  spent.cpu_s = processCpu_s();
  spent.peakMemory_bytes = processPeakMemory_bytes();
  report(reports, WorkerFinished{spent});
}

int failed(int reports, core::ErrorKind kind, const std::string& message) {
  writeLine(reports, toLine(WorkerFailed{kind, message}));
  return EXIT_FAILURE;
}

}  // namespace

Statistics makeSegments(LineReader& jobs, int reports, FrameSource& source, const SinkMaker& sinkOf,
                        const SegmentKeeper* keeper) {
  Statistics spent;
  spent.workers = 1;
  while (const auto line = jobs.wait()) {
    const FrameRange segment = segmentFromLine(*line);
    if (keeper && keeper->has(segment, source))
      reportReused(segment, reports);
    else
      makeSegment(segment, reports, source, *sinkOf(segment), keeper, spent);
    malloc_trim(0);  // an encoder's large blocks leave holes that the next one does not fit into
    report(reports, SegmentDone{segment});
  }
  spent.first_s = -spent.making.sum_s();
  spent.making += source.times();
  return spent;
}

int runWorker(int jobs, int reports) {
  watchInterruptsAsWorker();
  LineReader lines(jobs);
  try {
    work(lines, reports);
    return EXIT_SUCCESS;
  } catch (const Interrupted& interrupted) {
    return 128 + interrupted.signal();
  } catch (const core::Error& error) {
    return failed(reports, error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    return failed(reports, core::ErrorKind::kGraphics, "out of memory");
  } catch (const std::exception& error) {
    return failed(reports, core::ErrorKind::kGraphics, error.what());
  }
}

}  // namespace poinsot::app
