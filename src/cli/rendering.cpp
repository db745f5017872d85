// SPDX-License-Identifier: Apache-2.0
#include "cli/rendering.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/console.h"
#include "cli/dry_run.h"
#include "cli/exit_code.h"
#include "cli/notes.h"
#include "cli/worker_count.h"
#include "core/error.h"
#include "core/temporary_folder.h"
#include "core/text.h"
#include "figure/figure.h"
#include "job/manifest.h"
#include "job/progress.h"
#include "output/png_sequence.h"
#include "output/run_files.h"
#include "process/interrupt.h"
#include "request/output_target.h"
#include "request/subtitles.h"

namespace poinsot::cli {
namespace {

using request::OutputKind;

void enterTarget(output::RunFiles& files, const request::OutputTarget& target, const request::FrameRange& frames) {
  if (target.kind == OutputKind::kSequence)
    return files.writes(output::FramePattern(target.path.string()), frames.first, frames.last, "-o");
  for (const auto& file : figure::figureFiles(target.path)) files.writes(file, "-o");
}

void checkStandardOutput() {
  if (isatty(STDOUT_FILENO) != 0)
    throw core::usageError("-o -: standard output is a terminal; send it to a program or a file");
}

/// Creates the default folder, out/, if the output is there. Returns false if the folder is missing in a dry run.
bool prepareDefaultFolder(const RenderOptions& options, const request::OutputTarget& target) {
  const auto folder = target.path.parent_path();
  const bool results = options.output.empty() || folder == "out";
  std::error_code ignored;  // ignored: a later check of the target reports a missing folder
  if (results && !options.dryRun) std::filesystem::create_directory(folder, ignored);
  return !results || std::filesystem::exists(folder, ignored);
}

/// Creates the folder of a sequence. The folders of other targets have already been checked.
void prepareFolder(const request::OutputTarget& target) {
  if (target.kind == OutputKind::kSequence) output::PngSequence(output::FramePattern(target.path.string()));
}

job::ProgressStyle styleOf(const RenderOptions& options, std::int64_t frames) {
  // "auto" shows no bar for a single frame, which takes too little time.
  const bool silent = options.quiet || (frames == 1 && options.progress == "auto");
  return job::progressStyle(silent ? "none" : options.progress, errIsTerminal());
}

/// Scope that ends the progress bar, so that the next message starts on its own line.
class LineEnd {
 public:
  explicit LineEnd(job::Progress& progress) : progress_(progress) {}
  ~LineEnd() { progress_.end(); }
  LineEnd(const LineEnd&) = delete;

 private:
  job::Progress& progress_;
};

void sayHowToGoOn(std::int64_t kept, std::int64_t total, bool shard) {
  writeErr(fmt::format("poinsot: {} of {} frames are kept; to continue, run the same command{}\n", kept, total,
                       shard ? "" : " with --resume"));
}

job::RenderSummary runWithProgress(const RenderOptions& options, job::RenderRequest request) {
  const std::int64_t total = request::framesIn(request.segments());
  const bool shard = request.shard.has_value();
  job::Progress progress(styleOf(options, total), total, errColumns(), writeControl);
  const LineEnd lineEnd(progress);
  job::RenderJob job(std::move(request), [&](std::int64_t done, std::int64_t reused, double elapsed_s) {
    progress.update(done, reused, elapsed_s);
  });
  try {
    return job.run();
  } catch (...) {
    progress.end();
    if (job.framesKept() > 0 && !options.quiet) sayHowToGoOn(job.framesKept(), total, shard);
    throw;
  }
}

/// Returns the number of workers. Throws if memory does not suffice, before any file is created.
int workersOf(const RenderOptions& options, const job::RenderRequest& request) {
  // If there are more shards than segments, some shards have no segments.
  return workerCount(options, std::max(1, static_cast<int>(request.segments().size())), request);
}

/// Returns the subtitles to write as files. Empty for standard output and for pictures.
std::vector<request::Subtitle> subtitlesBeside(const request::OutputTarget& target, const scene::Scene& scene,
                                               const request::FrameRange& frames) {
  if (target.kind != OutputKind::kFilm || target.stream) return {};
  return request::subtitlesOf(scene, frames);
}

/// Returns a note if another film has the same name except for its ending, because both share NAME.srt. The
/// subtitles are either replaced and may not fit the other film, or kept although this film has no captions.
std::string sharedSubtitlesNote(const request::OutputTarget& target, const scene::Scene& scene,
                                const request::FrameRange& frames) {
  if (target.kind != OutputKind::kFilm || target.stream) return "";
  const auto subtitles = request::subtitlesOf(scene, frames);
  const auto name = [](const std::filesystem::path& path) { return core::printable(path.string()); };
  const auto files = request::subtitleFiles(target.path);
  const auto others = request::filmsWithSubtitlesOf(target.path);
  std::string notes;
  if (subtitles.empty() && !others.empty())
    for (const auto& file : request::ownSubtitleFiles(target.path))
      notes += fmt::format("poinsot: note: {} is kept, because it may belong to {}\n", name(file),
                           name(others.front()));
  if (subtitles.empty() || !request::replacesOthers(subtitles, target.path)) return notes;
  for (const auto& other : others)
    notes += fmt::format(
        "poinsot: note: {} and {} are replaced by the captions of {}, which differ; if the old captions belong to "
        "{}, give one of the two films another name\n",
        name(files[0]), name(files[1]), name(target.path), name(other));
  return notes;
}

std::string damageNote(const request::OutputTarget& target, const job::RenderSummary& summary) {
  if (!summary.replacedDamaged) return "";
  return fmt::format("poinsot: note: {} was damaged or changed after it was written, so it was made again\n",
                     core::printable(target.path.string()));
}

std::string completeText(const PartsOptions& parts, const request::OutputTarget& target) {
  return fmt::format("{} is complete: nothing is left to make for shard {}", core::printable(target.path.string()),
                     parts.shard);
}

/// Returns "out/film.mp4 is ready (420 frames, 60 of them already existed, 31.2 s)".
std::string readyText(const PartsOptions& parts, const request::OutputTarget& target,
                      const request::FrameRange& frames, const job::RenderSummary& summary) {
  const std::string what = target.stream ? "standard output" : core::printable(target.path.string());
  const std::string reused = summary.reused > 0 ? fmt::format(", {} of them already existed", summary.reused) : "";
  if (!parts.shard.empty())
    return fmt::format("shard {} of {} is done ({:.1f} s{}); `poinsot assemble` joins the shards", parts.shard,
                       what, summary.wall_s,
                       reused.empty() ? "" : fmt::format(", {} frames already existed", summary.reused));
  return fmt::format("{} is ready ({} frame{}{}, {:.1f} s)", what, frames.count(), frames.count() == 1 ? "" : "s",
                     reused, summary.wall_s);
}

job::RenderChoices completed(job::RenderChoices choices, const RenderOptions& options, const PartsOptions& parts) {
  choices.backend = requestedBackend(options);
  choices.reproducible = options.reproducible;
  choices.segmentFrames = parts.segmentFrames;
  choices.resume = parts.resume;
  choices.keepWork = parts.keep;
  if (!parts.shard.empty()) choices.shard = request::parseShard(parts.shard);
  if (parts.shardsLeft > 0) choices.shard = request::Shard{1, parts.shardsLeft};
  if (!parts.manifest.empty()) choices.manifest = parts.manifest;
  if (!options.trace.empty()) choices.trace = options.trace;
  return choices;
}

/// Calls `action`. After a failure, reports the file and the errno as JSON if progress is reported as JSON.
template <class Action>
auto reportingFailures(const RenderOptions& options, const Action& action) {
  try {
    return action();
  } catch (const core::FileError& error) {
    if (options.progress == "json") writeErr(job::jsonLine(error) + "\n");
    throw;
  }
}

std::string notesOn(const job::RenderRequest& render) {
  const scene::Scene& scene = render.scene.scene;
  return choiceNotes(scene, render.frames.count() > 1) + pictureNotes(render) +
         sharedSubtitlesNote(render.target, scene, render.frames) + shaderCacheNote(render);
}

/// Checks all files of a run. @throws core::Error
void checkFiles(const RenderOptions& options, const RequestedFilm& film, const request::PictureOptions& form,
                const PartsOptions& parts) {
  output::RunFiles files = checkMakeable(options, film, form);
  files.writes(parts.manifest, "--manifest", job::manifestKind());
  files.writes(options.trace, "--trace", job::traceKind());
}

/// Renders, and prints the result if it is written. @param notes  text to print before the result
job::RenderSummary make(const RenderOptions& options, job::RenderRequest render, const PartsOptions& parts,
                        const std::string& notes = "") {
  const request::OutputTarget target = render.target;
  const request::FrameRange frames = render.frames;
  std::optional<core::TemporaryFolder> parked;  // folder of segments that are not yet written to standard output
  if (target.stream) render.target.path = parked.emplace().path() / target.path;
  prepareFolder(render.target);
  process::watchInterrupts();
  const auto summary = runWithProgress(options, std::move(render));
  if (!summary.written) return summary;
  if (printsNotes(options))
    writeErr(notes + damageNote(target, summary) + rendererNotes({summary.renderer}) +
             "poinsot: " + readyText(parts, target, frames, summary) + "\n");
  if (options.stats) writeErr(job::statisticsText(summary.spent, summary.wall_s));
  return summary;
}

}  // namespace

bool printsNotes(const RenderOptions& options) { return !options.quiet && options.progress != "json"; }

FileAccess accessOf(const RenderOptions& options, const std::optional<request::OutputTarget>& target) {
  FileAccess access{{options.scene}, options.assetRoots};
  access.reproducible = options.reproducible;
  if (!options.dryRun) {  // creates folders now, because the sandbox cannot
    if (options.output.empty() || !target)
      access.made.emplace_back("out");
    else if (target->kind == OutputKind::kSequence && !target->stream)
      prepareFolder(*target);
  }
  if (target && !target->stream) access.outputs.push_back(target->path);
  access.outputs.push_back(options.trace);
  return access;
}

output::RunFiles checkMakeable(const RenderOptions& options, const RequestedFilm& film,
                               const request::PictureOptions& form) {
  const auto& [requested, target, frames] = film;
  const scene::Scene& scene = requested.scene;
  if (target.kind == OutputKind::kFilm)
    output::checkFormat(request::filmFormat(target, scene.output, form), requested.size(), scene.time.fps);
  output::RunFiles files = enteredInputs(options, scene, options.force);
  if (target.stream) {
    checkStandardOutput();
    return files;
  }
  if (prepareDefaultFolder(options, target)) {
    enterTarget(files, target, frames);
    request::enterSubtitles(files, subtitlesBeside(target, scene, frames), target.path);
  }
  return files;
}

job::RenderRequest renderOf(const RenderOptions& options, RequestedFilm film, job::RenderChoices choices,
                            const PartsOptions& parts) {
  return job::renderRequest(std::move(film.scene), film.target, film.frames,
                            completed(std::move(choices), options, parts));
}

int renderTo(const RenderOptions& options, RequestedFilm film, job::RenderChoices choices,
             const PartsOptions& parts) {
  return reportingFailures(options, [&]() -> int {
    checkFiles(options, film, choices.form, parts);
    job::RenderRequest render = renderOf(options, std::move(film), std::move(choices), parts);
    if (parts.shardsLeft > 0) return listShardsLeft(render);  // needs no workers, so no check of memory
    if (!options.dryRun && isShardOfFinishedFilm(render)) {
      if (!options.quiet) writeErr("poinsot: " + completeText(parts, render.target) + "\n");
      return kDone;
    }
    render.workers = workersOf(options, render);
    if (printsNotes(options)) writeErr(notesOn(render));
    if (options.dryRun) return describe(render);
    make(options, std::move(render), parts);
    return kDone;
  });
}

job::RenderSummary renderWithin(const RenderOptions& options, RequestedFilm film, job::RenderChoices choices,
                                const PartsOptions& parts) {
  return reportingFailures(options, [&] {
    checkFiles(options, film, choices.form, parts);
    job::RenderRequest render = renderOf(options, std::move(film), std::move(choices), parts);
    render.workers = workersOf(options, render);
    const std::string notes = printsNotes(options) ? notesOn(render) : "";
    return make(options, std::move(render), parts, notes);
  });
}

}  // namespace poinsot::cli
