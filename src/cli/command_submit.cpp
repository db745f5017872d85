// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <sstream>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/film_options.h"
#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/error.h"
#include "core/program_path.h"
#include "core/text.h"
#include "request/sweep_cells.h"
#include "stage/stage.h"

namespace poinsot::cli {
namespace {

using Words = std::vector<std::string>;

struct SubmitOptions : FilmOptions {
  std::string engine = "slurm", program;
  std::vector<std::string> setup;
  int shards = 0, retries = 3;
  double frame_s = 0, task_min = 0;
  bool keep = false;
  request::SweepRequest grid;
};

std::string fileWord(const std::string& name) { return name.starts_with('-') ? "./" + name : name; }

Words renderWords(const SubmitOptions& options, const request::OutputTarget& target) {
  Words words{options.sweep || options.series ? "sweep" : "render", fileWord(options.scene), "-o",
              fileWord(target.path.string())};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("-q", options.quality);
  for (const std::string& text : options.overrides) add("-D", text);
  if (options.view > 0) add("--view", std::to_string(options.view));
  add("--size", options.size);
  add("--fps", options.fps);
  add("--frames", options.frames);
  if (options.series) words.push_back("--series");
  if (options.loop) words.push_back("--loop");
  if (options.grid.columns > 0) add("--columns", std::to_string(options.grid.columns));
  for (const std::string& label : options.grid.labels) add("--label", label);
  std::ranges::copy(allowanceWords(options), std::back_inserter(words));
  if (options.untrusted) words.push_back("--untrusted");
  if (options.transparent) words.push_back("--transparent");
  if (options.bits != 8) add("--bits", std::to_string(options.bits));
  if (options.force) words.push_back("--force");
  if (options.backend != "auto") add("--backend", options.backend);
  if (options.parts.segmentFrames != request::kSegmentFrames)
    add("--segment", std::to_string(options.parts.segmentFrames));
  add("-j", std::to_string(options.jobs));
  return words;
}

Words assembleWords(const SubmitOptions& options, const request::OutputTarget& target) {
  Words words{"assemble", fileWord(target.path.string())};
  if (options.force) words.push_back("--force");
  if (options.keep) words.push_back("--keep");
  return words;
}

void checkKind(const request::OutputTarget& target) {
  if (target.stream) throw core::usageError("-o -: not possible, because tasks on several machines write files");
  if (target.kind == request::OutputKind::kPicture)
    throw core::usageError(fmt::format("{}: one picture is made by one process; submit is for films and sequences",
                                       core::printable(target.path.string())));
}

std::vector<std::filesystem::path> inputFiles(const SubmitOptions& options, const scene::Scene& scene) {
  std::vector<std::filesystem::path> files{options.scene};
  for (const scene::InputFile& input : scene.inputs) files.push_back(input.place);
  return files;
}

cluster::DivisionRequest divisionRequest(const SubmitOptions& options) {
  cluster::DivisionRequest request;
  request.cpus = options.jobs;
  if (options.shards > 0) request.shards = options.shards;
  if (options.task_min > 0) request.task_s = 60 * options.task_min;
  if (options.frame_s > 0) request.frame_s = options.frame_s;
  return request;
}

/// Returns what the lines do not say themselves, because each of them is a command.
std::string linesNote(const cluster::Submission& submission) {
  const cluster::Division& division = submission.division;
  return fmt::format("poinsot: {} task{} of about {} on {} CPU{} with {} MiB; the last line {}, after them\n",
                     division.shards, division.shards == 1 ? "" : "s", cluster::durationText(division.task_s),
                     division.cpus, division.cpus == 1 ? "" : "s", division.cpus * division.memory,
                     cluster::lastStep(submission));
}

std::string scriptOf(const std::string& engine, const cluster::Submission& submission) {
  if (engine == "lines") return cluster::linesScript(submission);
  if (engine == "parallel") return cluster::parallelScript(submission);
  return engine == "make" ? cluster::makeScript(submission) : cluster::slurmScript(submission);
}

Words programWords(const std::string& asked) {
  Words words;
  std::istringstream text(asked);
  for (std::string word; text >> word;) words.push_back(word);
  return words.empty() ? Words{core::programPath().string()} : words;
}

void checkGrid(const SubmitOptions& options) {
  if (options.sweep && options.loop)
    throw core::usageError("--loop: not possible in a sweep, because each of its motions would change");
  if (!options.sweep && (options.grid.columns > 0 || !options.grid.labels.empty()))
    throw core::usageError("--columns and --label: need a grid, that is, -D with a range");
}

/// Work to divide: the segments of a film, or the films of a series.
struct Work {
  request::OutputTarget output;
  std::int64_t frames = 0;
  std::vector<request::FrameRange> pieces;
  image::PixelSize size = {};
  double worker_bytes = 0;
  std::vector<std::filesystem::path> inputs;
};

/// Checks everything that can fail before drawing, so that it fails here, instead of later in the queue.
Work workOf(const SubmitOptions& options) {
  const RequestedFilm film = requestedFilm(options);
  const auto& [requested, target, frames] = film;
  checkKind(target);
  checkMakeable(options, film, pictureOptions(options));
  if (!options.sweep) const stage::Stage stage(requested.scene);  // throws if the motion lacks something to show
  const auto render = job::renderRequest(requested, target, frames, {.form = pictureOptions(options)});
  job::expectWithinMemory(render);
  return {target,           frames.count(),      request::segmentsOf(frames, options.parts.segmentFrames),
          requested.size(), render.worker_bytes, inputFiles(options, requested.scene)};
}

Work workOfSeries(const SubmitOptions& options) {
  Work all{{request::OutputKind::kSequence, options.output}, 0, {}, {}, 0, {}};
  for (const request::SeriesFilm& one : seriesOf(options)) {
    SubmitOptions film = options;
    setFilm(film, one);
    Work work = workOf(film);
    all.pieces.push_back({all.frames, all.frames + work.frames - 1});
    all.frames += work.frames;
    all.size = {std::max(all.size.width, work.size.width), std::max(all.size.height, work.size.height)};
    all.worker_bytes = std::max(all.worker_bytes, work.worker_bytes);
    all.inputs = std::move(work.inputs);
  }
  return all;
}

int submit(SubmitOptions options) {
  if (!options.series && request::isSeriesName(options.output))
    throw core::usageError("-o: {value} stands for a value in the names of a series; add --series");
  if (!options.series && request::hasRanges(options.overrides)) options.sweep = options.grid;
  checkGrid(options);
  Work work = options.series ? workOfSeries(options) : workOf(options);
  cluster::Submission submission;
  submission.program = programWords(options.program);
  submission.setup = options.setup;
  submission.folder = std::filesystem::current_path();
  submission.render = renderWords(options, work.output);
  if (!options.series) submission.assemble = assembleWords(options, work.output);
  submission.inputs = std::move(work.inputs);
  submission.frames = work.frames;
  submission.pieces = fmt::format("{} {}{}", work.pieces.size(), options.series ? "film" : "segment",
                                  work.pieces.size() == 1 ? "" : "s");
  submission.division = cluster::divisionOf(divisionRequest(options), {0, work.frames - 1}, work.pieces, work.size,
                                            work.worker_bytes);
  submission.output = std::move(work.output);
  submission.retries = options.retries;
  writeOut(scriptOf(options.engine, submission));
  if (options.engine == "lines") writeErr(linesNote(submission));
  return kDone;
}

void addDivisionOptions(const Command& command, SubmitOptions& options) {
  options.jobs = 1;
  command
      .option("--engine", options.engine,
              "slurm, parallel (GNU parallel), make, or lines: one command per line for any other queue, the last "
              "of which joins (default: slurm)")
      .type("NAME")
      .among({"slurm", "parallel", "make", "lines"});
  command
      .option("--setup", options.setup,
              "shell command that each task runs before poinsot, such as 'module load mesa'")
      .type("LINE")
      .repeats()
      .notEmpty();
  command
      .option("--program", options.program,
              "words, separated by blanks, that start poinsot in a task, such as 'apptainer exec poinsot.sif "
              "poinsot' (default: the path "
              "of this program)")
      .type("WORDS")
      .notEmpty();
  command.option("--shards", options.shards, "number of tasks (default: as many as --task-minutes gives)")
      .type("N")
      .range(1, 100'000);
  command.option("--task-minutes", options.task_min, "minutes that a task should take (default: 10)")
      .type("M")
      .range(0.1, 1e5);
  command
      .option("--frame-seconds", options.frame_s,
              "CPU time of a frame in seconds, as printed by --stats of a short render (default: estimated from "
              "the size)")
      .type("S")
      .range(1e-3, 1e5);
  command.option("-j,--jobs", options.jobs, "CPUs of a task (default: 1)").type("N").range(1, 1024);
  command
      .option("--retries", options.retries,
              "how often a failed task is tried again, in Slurm counted per segment (default: 3)")
      .type("N")
      .range(0, 100);
  command.flag("--keep", options.keep, "keep the segments when the film is ready");
}

}  // namespace

void addSubmit(const Command& program) {
  auto options = std::make_shared<SubmitOptions>();
  const Command command = program.command(
      "submit", "print a script that makes a film on a cluster: for Slurm, GNU parallel, make and others");
  addSceneOptions(command, *options);
  addViewOption(command, *options);
  addLookOptions(command, *options);
  addFilmOptions(command, *options);
  command.remove("--max-size");  // removed, because a shard cannot know the size of the film
  addGridOptions(command, options->grid);
  addSeriesOption(command, *options);
  addDivisionOptions(command, *options);
  command.footer(
      "submit starts nothing: it prints a script to read, change and run. The film has the same bytes as one\n"
      "from render --reproducible on one machine; with a range in -D, as one from sweep. --series makes a film\n"
      "of its own for each value, and each task makes some of these films. If a task or the\n"
      "joining fails, run the same script again: it submits only the remaining work, or nothing if the film "
      "exists.\n"
      "Examples:\n"
      "  poinsot submit scenes/football.toml -o out/football.mp4 > football.sh && bash football.sh\n"
      "  poinsot submit scenes/football.toml -q 4k --engine make --shards 8 > football.mk && make -f football.mk "
      "-j 8");
  command.does({[options] { return submit(*options); }, options.get(),
                [options] { return accessOf(*options, namedTarget(*options)); }});
}

}  // namespace poinsot::cli
