// SPDX-License-Identifier: Apache-2.0
#include "job/render_job.h"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "core/expect.h"
#include "core/file_error.h"
#include "figure/figure.h"
#include "gl/offscreen_context.h"
#include "job/assembly.h"
#include "job/manifest.h"
#include "job/segment_sink.h"
#include "process/interrupt.h"
#include "request/memory.h"

namespace poinsot::job {
namespace {

// Time limit for stopping workers, which check for signals after each frame. The limit is long compared with a
// frame, but lets the program end within 2 s.
constexpr double kPatience_s = 1.5;

/// Returns a hint about lack of memory if a worker died of a typical signal. LLVM aborts if an allocation fails,
/// the kernel kills a process that uses too much memory, and a page that cannot be provided causes a bus error.
std::string perhapsMemory(const std::string& how, double estimate_bytes) {
  const auto by = [&](int signal) { return how.find(fmt::format("by signal {} ", signal)) != std::string::npos; };
  if (!by(SIGABRT) && !by(SIGKILL) && !by(SIGBUS)) return "";
  return fmt::format("; perhaps memory ran out: the worker was expected to need about {}",
                     request::memoryText(estimate_bytes));
}

[[noreturn]] void reportDeath(WorkerProcess& worker, double estimate_bytes) {
  worker.kill();
  const std::string how = worker.ended(1).value_or("does not end");
  const std::string task =
      worker.segment() ? fmt::format("while making frames {}-{}", worker.segment()->first, worker.segment()->last)
                       : "at its end";
  throw core::graphicsError(
      fmt::format("a worker process {} {}{}", how, task, perhapsMemory(how, estimate_bytes)));
}

WorkFolderUse useOf(const RenderRequest& request) {
  if (request.shard) return WorkFolderUse::kShared;
  return request.resume ? WorkFolderUse::kResumed : WorkFolderUse::kFresh;
}

}  // namespace

int availableCpus() {
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  const bool known = sched_getaffinity(0, sizeof cpus, &cpus) == 0;
  return known ? std::max(1, CPU_COUNT(&cpus)) : 1;
}

RenderJob::RenderJob(RenderRequest request, FrameListener listener)
    : request_(std::move(request)),
      listener_(std::move(listener)),
      start_(std::chrono::steady_clock::now()),
      folder_(request_.target.path, useOf(request_)),
      segments_(request_.segments()),
      waiting_(segments_.begin(), segments_.end()) {
  POINSOT_EXPECT(request_.workers > 0);
  if (request_.accepted) folder_.discard();
  if (request_.trace) trace_.emplace(*request_.trace, folder_.path());
  if (request_.record) writeJobRecord(folder_.path(), *request_.record);
  if (request_.target.stream) stream_.emplace(request_.target, *request_.record, folder_.path());
}

RenderJob::~RenderJob() { stopWorkers(); }

RenderSummary RenderJob::run() {
  begin();
  while (isMaking()) {
    awaitReports({this});
    takeReports();
  }
  return end();
}

void RenderJob::begin() {
  found_ = stateBefore();
  removeOldManifest();
  if (!isFinished()) traced("start workers", [this] { startWorkers(); });
}

RenderSummary RenderJob::end() {
  summary_.replacedDamaged = found_ == output::FilmState::kDamaged;
  if (isFinished()) summary_.reused = request_.frames.count();
  core::FileBatch results;
  traced("assemble", [&] { gather(results); });
  summary_.wall_s = elapsed_s();
  if (request_.accepted && !isAccepted(results)) return summary_;
  if (request_.manifest) addManifest(results);
  if (trace_) addAbout(results, trace_->finish());
  results.commit();
  summary_.wall_s = elapsed_s();
  if (!request_.shard && !request_.keepWork) folder_.discard();
  return summary_;
}

/// Measures the film, and returns whether its size is accepted.
bool RenderJob::isAccepted(const core::FileBatch& results) {
  summary_.film_bytes =
      static_cast<std::int64_t>(std::filesystem::file_size(results.contentOf(request_.target.path)));
  return summary_.written = request_.accepted->contains(summary_.film_bytes);
}

void RenderJob::traced(const char* name, const std::function<void()>& work) {
  const std::int64_t begin_ns = core::monotonic_ns();
  work();
  if (trace_) trace_->add(kParentProcess, {name, begin_ns, core::monotonic_ns()});
}

/// Returns the state of an earlier film of this job at the target. Such a film exists if an earlier render was
/// stopped during its cleanup; then nothing is left to render. With --manifest the film does not count, because
/// the manifest needs the segments.
output::FilmState RenderJob::stateBefore() const {
  const bool resumed = request_.resume && !request_.shard && !request_.manifest && request_.record;
  return resumed ? filmState(*request_.record, request_.target.path) : output::FilmState::kOther;
}

void RenderJob::startWorkers() {
  const int count = std::min<int>(request_.workers, static_cast<int>(segments_.size()));
  if (count == 0) return;  // if there are more shards than segments, some shards are empty
  // Uses CPUs without a worker for threads of the rasteriser. These threads do not change the pixels.
  const int perWorker = request_.workers / count;
  const WorkerTask task{request_, folder_.path(), perWorker > 1 ? perWorker : 0};
  if (count > 1) gl::preload(request_.backend);
  for (int i = 0; i < count; ++i) {
    process::throwIfInterrupted();
    workers_.push_back(std::make_unique<WorkerProcess>(task, i + 1));
    handOut(*workers_.back());
  }
}

void RenderJob::watch(std::vector<pollfd>& watched) const {
  for (const auto& worker : workers_) watched.push_back({worker->reportsFd(), POLLIN, 0});
}

void RenderJob::takeReports() {
  std::vector<pollfd> watched;
  watch(watched);
  if (poll(watched.data(), watched.size(), 0) < 0) return;  // a signal, which awaitReports() handles
  for (std::size_t i = 0; i < workers_.size(); ++i) {
    if (watched[i].revents == 0) continue;
    WorkerProcess& worker = *workers_[i];
    const bool open = worker.readReports();
    while (const auto report = worker.takeReport()) handle(worker, *report);
    if (!open && !worker.finished()) reportDeath(worker, request_.worker_bytes);
  }
  std::erase_if(workers_, [](const auto& worker) { return worker->finished(); });
}

void RenderJob::handle(WorkerProcess& worker, const WorkerReport& report) {
  if (const auto* done = std::get_if<FrameDone>(&report)) {
    summary_.reused += done->reused ? 1 : 0;
    summary_.pixels = done->pixels;
    listener_(++framesDone_, summary_.reused, elapsed_s());
  }
  if (const auto* done = std::get_if<SegmentDone>(&report)) {
    segmentFramesDone_ += done->frames.count();
    countWritten(done->frames);
    if (stream_) traced("send on", [&] { sendOn(done->frames); });
    handOut(worker);
  }
  if (const auto* done = std::get_if<SpansDone>(&report))
    for (const core::Span& span : done->spans) trace_->add(worker.number(), span);
  if (const auto* finished = std::get_if<WorkerFinished>(&report)) {
    summary_.spent += finished->spent;
    summary_.driver = finished->driver;
    summary_.renderer = finished->renderer;
    worker.setFinished();
  }
  if (const auto* failed = std::get_if<WorkerFailed>(&report)) {
    if (failed->file.empty()) throw core::Error(failed->kind, failed->message);
    throw core::FileError(failed->kind, failed->message, failed->file, failed->code);
  }
}

/// Adds the file sizes of a completed segment to the total size of the output. Ignores stills, whose size is known
/// before the render.
/// @throws core::Error(kLimit) if the total exceeds Limit::kOutput
void RenderJob::countWritten(const request::FrameRange& segment) {
  if (!request_.record) return;
  for (const auto& file : segmentFiles(folder_.path(), request_.target, segment)) {
    std::error_code failure;
    const auto bytes = std::filesystem::file_size(file, failure);
    if (!failure) written_bytes_ += static_cast<double>(bytes);
  }
  constexpr auto kOutput = scene::Limit::kOutput;
  const scene::Limits& limits = request_.scene.request.allowance.limits;
  if (written_bytes_ <= static_cast<double>(limits[kOutput])) return;
  throw core::limitError(fmt::format("{:.0f} bytes are written after {} of {} frames; a run may write {}; {}",
                                     written_bytes_, segmentFramesDone_, request::framesIn(segments_),
                                     limitText(kOutput, limits[kOutput]), howToRaise(kOutput)));
}

void RenderJob::handOut(WorkerProcess& worker) {
  if (waiting_.empty()) return worker.giveNoMore();
  worker.give(waiting_.front());
  waiting_.pop_front();
}

void RenderJob::sendOn(const request::FrameRange& segment) try {
  stream_->add(segment);
} catch (const core::Error&) {
  process::throwIfInterrupted();  // reports a signal instead of the write error that it causes
  throw;
}

void RenderJob::gather(core::FileBatch& results) {
  const request::OutputTarget& target = request_.target;
  if (stream_) return stream_->finish();
  if (request_.shard) return;
  if (!request_.record) return gatherStill(results);
  if (isFinished()) return request::addSubtitlesOfFinished(results, request_.record->subtitles, target.path);
  assemble(results, folder_.path(), *request_.record, target, target.path);
}

void RenderJob::gatherStill(core::FileBatch& results) const {
  const auto files = figure::figureFiles(request_.target.path);
  const auto places = stagedFiles(folder_.path(), request_.target);
  results.add(core::AtomicFile::of(places.front(), files.front()));
  for (std::size_t i = 1; i < files.size(); ++i) results.addBeside(core::AtomicFile::of(places[i], files[i]));
}

void RenderJob::addManifest(core::FileBatch& results) const {
  const request::OutputTarget& target = request_.target;
  core::AtomicFile file(*request_.manifest);
  file.write(manifestText(folder_.path(), *request_.record, target, results.contentOf(target.path), summary_));
  addAbout(results, std::move(file));
}

/// Adds a file that describes the output, such as a manifest. The file is a companion of the output, except for a
/// sequence: its batch is empty, because the frames already have their final names.
void RenderJob::addAbout(core::FileBatch& results, core::AtomicFile file) {
  if (results.empty())
    results.add(std::move(file));
  else
    results.addBeside(std::move(file));
}

/// Removes the manifest of an earlier run, because the first new frame of a sequence invalidates it.
void RenderJob::removeOldManifest() const {
  std::error_code ignored;  // ignored, because the manifest is replaced at the end
  if (request_.manifest && request_.target.kind == request::OutputKind::kSequence)
    std::filesystem::remove(*request_.manifest, ignored);
}

std::int64_t RenderJob::framesKept() const {
  return request_.record && !stream_ && !request_.accepted ? segmentFramesDone_ : 0;
}

void RenderJob::askToStop() {
  for (const auto& worker : workers_) worker->askToStop();
}

void RenderJob::stopWorkers() {
  askToStop();
  const double deadline_s = elapsed_s() + kPatience_s;
  for (const auto& worker : workers_) worker->awaitEnd(std::max(0.0, deadline_s - elapsed_s()));
  workers_.clear();
}

double RenderJob::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void awaitReports(const std::vector<const RenderJob*>& jobs) {
  std::vector<pollfd> watched{{process::interruptFd(), POLLIN, 0}};
  for (const RenderJob* job : jobs) job->watch(watched);
  if (poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR)
    throw core::graphicsError("cannot wait for the workers");
  process::throwIfInterrupted();
}

}  // namespace poinsot::job
