// SPDX-License-Identifier: Apache-2.0
#include "job/worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "core/file_handle.h"
#include "image/pixel_digest.h"
#include "job/job_identity.h"
#include "job/worker_protocol.h"
#include "support/scratch_folder.h"

namespace poinsot::job {
namespace {

/// Frame k is one grey pixel of value k.
struct GreySource : FrameSource {
  image::Frame frame(std::int64_t k) override {
    image::Image grey({1, 1}, 3);
    grey.pixels.assign(3, static_cast<std::uint8_t>(k));
    picture = grey;
    // Each frame costs 1 and 4 s.
    steps.add(core::Step::kSimulate, 1);
    steps.add(core::Step::kText, 4);
    return picture;
  }
  core::Digest digest(std::int64_t k) override { return core::sha256(std::to_string(k)); }
  image::AnyImage picture;
  core::StepLedger steps;
};

using Written = std::vector<std::pair<std::int64_t, int>>;  // k and grey value, -1 for finish()

struct RecordingSink : output::FrameSink {
  explicit RecordingSink(Written& log) : log_(log) {}
  void write(const image::Frame& frame, std::int64_t k) override {
    log_.emplace_back(k, std::get<image::Image>(frame.picture).pixels[0]);
  }
  void finish() override { log_.emplace_back(0, -1); }
  Written& log_;
};

struct Pipe {
  core::FileHandle read, write;
  Pipe() {
    int ends[2];
    if (pipe(ends) == 0) {
      read = core::FileHandle(ends[0]);
      write = core::FileHandle(ends[1]);
    }
  }
};

TEST(Worker, MakesSegmentsInTurnAndReportsEach) {
  Pipe jobs, reports;
  process::writeLine(jobs.write.get(), toLine(request::FrameRange{3, 4}));
  process::writeLine(jobs.write.get(), toLine(request::FrameRange{60, 60}));
  jobs.write.reset();
  process::LineReader lines(jobs.read.get());
  GreySource source;
  Written written;
  source.steps.trace();
  const auto spent = makeSegments(
      lines, reports.write.get(), source,
      [&](const request::FrameRange&) { return std::make_unique<RecordingSink>(written); }, source.steps, nullptr,
      true);
  EXPECT_EQ(written, (Written{{3, 3}, {4, 4}, {0, -1}, {60, 60}, {0, -1}}));
  EXPECT_EQ(spent.frames, 3);
  EXPECT_EQ(spent.workers, 1);
  EXPECT_EQ(spent.first_s, 5);                       // 1 + 4
  EXPECT_EQ(spent.steps[core::Step::kSimulate], 2);  // of the two others
  EXPECT_EQ(spent.steps[core::Step::kText], 8);

  reports.write.reset();
  process::LineReader told(reports.read.get());
  std::vector<std::int64_t> frames, segmentStarts, tracedSegments;
  while (const auto line = told.wait()) {
    const auto report = reportFromLine(*line);
    if (const auto* done = std::get_if<FrameDone>(&report)) {
      frames.push_back(done->k);
      EXPECT_EQ(done->pixels, image::pixelDigest(GreySource().frame(done->k).picture));
    }
    if (const auto* done = std::get_if<SegmentDone>(&report)) segmentStarts.push_back(done->frames.first);
    if (const auto* done = std::get_if<SpansDone>(&report))
      for (const core::Span& span : done->spans) tracedSegments.push_back(span.frame.value());
  }
  EXPECT_EQ(frames, (std::vector<std::int64_t>{3, 4, 60}));
  EXPECT_EQ(segmentStarts, (std::vector<std::int64_t>{3, 60}));
  EXPECT_EQ(tracedSegments, segmentStarts);
}

/// The last word of a worker, a process of its own, that is given the job and no segment.
WorkerReport lastWordOf(const WorkerJob& job) {
  Pipe jobs, reports;
  process::writeLine(jobs.write.get(), toLine(job));
  jobs.write.reset();
  const pid_t worker = fork();
  if (worker == 0) _exit(runWorker(jobs.read.get(), reports.write.get()));
  reports.write.reset();
  process::LineReader told(reports.read.get());
  WorkerReport last = FrameDone{};
  while (const auto line = told.wait()) last = reportFromLine(*line);
  waitpid(worker, nullptr, 0);
  return last;
}

TEST(Worker, TellsThatAFileOfTheSceneHasChanged) {
  const ScratchFolder folder;
  folder.put("style.toml", "[style]\ntheme = \"dark\"\n");
  const std::string scene = folder / "a.toml";
  WorkerJob job;
  job.scene = {scene,
               "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0.1]\n"
               "[style]\nfile = \"style.toml\"\n",
               {},
               {}};
  job.target = {request::OutputKind::kSequence, folder / "{frame}.png"};
  job.workFolder = folder.path();
  const scene::Scene read = request::loadRequested(job.scene);
  job.job =
      core::toHex(jobDigest(sceneDigest(job.scene, read),
                            renderSettings(job.target, job.form, job.reproducible, job.segmentFrames, read)));
  EXPECT_TRUE(std::holds_alternative<WorkerFinished>(lastWordOf(job)));

  folder.put("style.toml", "[style]\ntheme = \"light\"\n");
  const WorkerReport last = lastWordOf(job);
  ASSERT_TRUE(std::holds_alternative<WorkerFailed>(last));
  EXPECT_EQ(std::get<WorkerFailed>(last).kind, core::ErrorKind::kIo);
  EXPECT_EQ(std::get<WorkerFailed>(last).message,
            scene + ": a file that the scene names has changed since the render began");
}

TEST(WorkerProtocol, CarriesAJobUnchanged) {
  // Bytes that are no UTF-8 and characters that JSON escapes: file names may hold both.
  const std::string odd = "a\"b\\c\n\xff\xc3\xa9\x80";
  scene::Allowance allowance{{}, {odd, "b"}};
  allowance.limits.set(scene::Limit::kSide, 16384);
  allowance.limits.set(scene::Limit::kMemory, std::int64_t{1} << 50);
  const WorkerJob job{{odd, "schema = 1\n# " + odd, {"a.b=" + odd}, image::PixelSize{161, 90}, allowance},
                      {request::OutputKind::kSequence, odd + "/{frame}.png"},
                      {3, 62},
                      0.1,
                      odd,
                      gl::Backend::kEgl,
                      true,
                      2,
                      {request::PrintSize{86.25, 599.9}, true, 16},
                      7,
                      true,
                      "0123",
                      true,
                      2.5e8};
  const std::string line = toLine(job);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const WorkerJob read = jobFromLine(line);
  EXPECT_EQ(read.scene.fileName, job.scene.fileName);
  EXPECT_EQ(read.scene.text, job.scene.text);
  EXPECT_EQ(read.scene.overrides, job.scene.overrides);
  EXPECT_EQ(read.scene.size, job.scene.size);
  EXPECT_EQ(read.scene.allowance.limits, allowance.limits);
  EXPECT_EQ(read.scene.allowance.assetRoots, allowance.assetRoots);
  EXPECT_EQ(read.target.kind, job.target.kind);
  EXPECT_EQ(read.target.path, job.target.path);
  EXPECT_EQ(read.frames, job.frames);
  EXPECT_EQ(read.time_s, job.time_s);
  EXPECT_EQ(read.workFolder, job.workFolder);
  EXPECT_EQ(read.backend, job.backend);
  EXPECT_EQ(read.reproducible, job.reproducible);
  EXPECT_EQ(read.rasterThreads, job.rasterThreads);
  ASSERT_TRUE(read.form.print);
  EXPECT_EQ(read.form.print->width_mm, 86.25);
  EXPECT_EQ(read.form.print->dpi, 599.9);
  EXPECT_TRUE(read.form.transparent);
  EXPECT_EQ(read.form.bits, 16);
  EXPECT_EQ(read.segmentFrames, 7);
  EXPECT_TRUE(read.resume);
  EXPECT_EQ(read.job, job.job);
  EXPECT_TRUE(read.trace);
  EXPECT_EQ(read.expected_bytes, 2.5e8);
}

TEST(WorkerProtocol, LeavesOutWhatWasNotGiven) {
  const WorkerJob read = jobFromLine(toLine(WorkerJob{}));
  EXPECT_EQ(read.scene.size, std::nullopt);
  EXPECT_EQ(read.scene.allowance.limits, scene::Limits());
  EXPECT_EQ(read.time_s, std::nullopt);
  EXPECT_FALSE(read.form.print);
  EXPECT_FALSE(read.form.transparent);
  EXPECT_EQ(read.form.bits, 8);
}

TEST(WorkerProtocol, SaysThatALineIsLostOrDamaged) {
  const std::string job = toLine(WorkerJob{}), segment = toLine(request::FrameRange{0, 29});
  const auto expectSaid = [](const auto& reading) {
    try {
      reading();
      ADD_FAILURE();
    } catch (const core::Error& error) {
      EXPECT_STREQ(error.what(),
                   "a message between the render and a worker process was lost or damaged; run it again");
    }
  };
  expectSaid([&] { jobFromLine(segment); });  // the job's own line did not come
  expectSaid([&] { segmentFromLine(job); });
  expectSaid([&] { jobFromLine(job.substr(0, job.size() / 2)); });
  expectSaid([&] { reportFromLine(segment.substr(1)); });
  expectSaid([&] { reportFromLine("{}"); });
}

TEST(WorkerProtocol, CarriesReports) {
  const auto failed =
      std::get<WorkerFailed>(reportFromLine(toLine(WorkerFailed{core::ErrorKind::kIo, "disk\nfull"})));
  EXPECT_EQ(failed.kind, core::ErrorKind::kIo);
  EXPECT_EQ(failed.message, "disk\nfull");
  EXPECT_TRUE(failed.file.empty());
  const auto full = std::get<WorkerFailed>(
      reportFromLine(toLine(WorkerFailed{core::ErrorKind::kIo, "full", "a\xff.mp4", ENOSPC})));
  EXPECT_EQ(full.file, "a\xff.mp4");
  EXPECT_EQ(full.code, ENOSPC);
  Statistics spent{7, 3, 0.9, {}, 0.7, 8};
  for (std::size_t i = 0; i < core::kSteps; ++i)
    spent.steps[static_cast<core::Step>(i)] = 0.1 * static_cast<double>(i);
  const auto finished =
      std::get<WorkerFinished>(reportFromLine(toLine(WorkerFinished{spent, "llvmpipe \xff", "Mesa 22.3.6"})));
  EXPECT_EQ(finished.renderer, "llvmpipe \xff");
  EXPECT_EQ(finished.driver, "Mesa 22.3.6");
  const Statistics& back = finished.spent;
  EXPECT_EQ(back.frames, 7);
  EXPECT_EQ(back.workers, 3);
  EXPECT_EQ(back.first_s, 0.9);
  for (std::size_t i = 0; i < core::kSteps; ++i)
    EXPECT_EQ(back.steps[static_cast<core::Step>(i)], spent.steps[static_cast<core::Step>(i)]) << i;
  EXPECT_EQ(back.cpu_s, 0.7);
  EXPECT_EQ(back.peakMemory_bytes, 8);
}

TEST(WorkerProtocol, CarriesSpansToTheNanosecond) {
  const std::int64_t late_ns =
      9'000'000'000'000'000'001;  // 285 years after the machine's start: no double holds it
  const SpansDone done{{{"draw", late_ns, late_ns + 1, 7}, {"write", 2, 3, std::nullopt}}};
  const auto back = std::get<SpansDone>(reportFromLine(toLine(done))).spans;
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].name, "draw");
  EXPECT_EQ(back[0].begin_ns, late_ns);
  EXPECT_EQ(back[0].end_ns, late_ns + 1);
  EXPECT_EQ(back[0].frame, 7);
  EXPECT_EQ(back[1].frame, std::nullopt);
}

}  // namespace
}  // namespace poinsot::job
