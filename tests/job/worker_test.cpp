// SPDX-License-Identifier: Apache-2.0
#include "job/worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "image/pixel_digest.h"
#include "image/png_file.h"
#include "job/worker_protocol.h"
#include "support/pipe.h"
#include "support/scratch_folder.h"

namespace poinsot::job {
namespace {

/// Source whose frame k is one grey pixel of value k.
struct GreySource : FrameSource {
  image::Frame frame(std::int64_t k) override {
    image::Image grey({1, 1}, 3);
    grey.pixels.assign(3, static_cast<std::uint8_t>(k));
    picture = grey;
    // Each frame takes 1 s to simulate and 4 s for its text.
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

TEST(Worker, WritesSegmentsInOrderAndReportsEach) {
  Pipe segments, reports;
  process::writeLine(segments.write.get(), toLine(request::FrameRange{3, 4}));
  process::writeLine(segments.write.get(), toLine(request::FrameRange{60, 60}));
  segments.write.reset();
  process::LineReader lines(segments.read.get());
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
  EXPECT_EQ(spent.steps[core::Step::kSimulate], 2);  // the two other frames
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

/// Returns the last report of a worker process that writes the request's frames as a sequence into a folder.
WorkerReport lastWordOf(const RenderRequest& render, const std::filesystem::path& folder) {
  Pipe segments, reports;
  process::writeLine(segments.write.get(), toLine(render.frames));
  segments.write.reset();
  const pid_t worker = fork();
  if (worker == 0) _exit(runWorker({render, folder, 0}, segments.read.get(), reports.write.get()));
  reports.write.reset();
  process::LineReader told(reports.read.get());
  WorkerReport last = FrameDone{};
  while (const auto line = told.wait()) last = reportFromLine(*line);
  waitpid(worker, nullptr, 0);
  return last;
}

// Otherwise a film could show two scenes without any message.
TEST(Worker, DrawsTheLoadedSceneEvenIfItsFilesChange) {
  const ScratchFolder folder;
  folder.put("style.toml", "[style]\ntheme = \"dark\"\n");
  const auto scene = request::requestedScene(
      {.fileName = folder / "a.toml",
       .text = "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0.1]\n"
               "[style]\nfile = \"style.toml\"\n[output]\nsize = [64, 36]\n"});
  const auto render = [&](const char* name) {
    return renderRequest(scene, {request::OutputKind::kSequence, folder / name}, {0, 0});
  };
  EXPECT_TRUE(std::holds_alternative<WorkerFinished>(lastWordOf(render("a{frame}.png"), folder.path())));
  for (const char* now : {"[style]\ntheme = \"light\"\n", "no style"}) {
    folder.put("style.toml", now);
    EXPECT_TRUE(std::holds_alternative<WorkerFinished>(lastWordOf(render("b{frame}.png"), folder.path()))) << now;
    EXPECT_EQ(image::pixelDigest(image::readPng(folder / "b0.png")),
              image::pixelDigest(image::readPng(folder / "a0.png")));
  }
}

TEST(WorkerProtocol, ReportsLostOrDamagedLines) {
  const std::string report = toLine(FrameDone{}), segment = toLine(request::FrameRange{0, 29});
  const auto expectSaid = [](const auto& reading) {
    try {
      reading();
      ADD_FAILURE();
    } catch (const core::Error& error) {
      EXPECT_STREQ(error.what(),
                   "a message between the render and a worker process was lost or damaged; run the command again");
    }
  };
  expectSaid([&] { segmentFromLine(report); });
  expectSaid([&] { segmentFromLine(segment.substr(0, segment.size() / 2)); });
  expectSaid([&] { reportFromLine(segment.substr(1)); });
  expectSaid([&] { reportFromLine("{}"); });
}

TEST(WorkerProtocol, RoundTripsReports) {
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

TEST(WorkerProtocol, RoundTripsSpansToTheNanosecond) {
  const std::int64_t late_ns =
      9'000'000'000'000'000'001;  // 285 years after the machine's start, too exact for a double
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
