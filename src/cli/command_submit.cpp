// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/film_options.h"
#include "cluster/submission.h"
#include "core/error.h"
#include "core/program_path.h"
#include "core/text.h"
#include "request/sweep_cells.h"
#include "stage/stage.h"

namespace poinsot::cli {
namespace {

using Words = std::vector<std::string>;

struct SubmitOptions : FilmOptions {
  std::string engine = "slurm";
  int shards = 0, retries = 3;
  double frame_s = 0, task_min = 0;
  bool keep = false;
  request::SweepRequest grid;
};

std::string fileWord(const std::string& name) { return name.starts_with('-') ? "./" + name : name; }

Words renderWords(const SubmitOptions& options, const request::OutputTarget& target) {
  Words words{options.sweep ? "sweep" : "render", fileWord(options.scene), "-o", fileWord(target.path.string())};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("-q", options.quality);
  for (const std::string& text : options.overrides) add("-D", text);
  if (options.view > 0) add("--view", std::to_string(options.view));
  add("--size", options.size);
  add("--fps", options.fps);
  add("--frames", options.frames);
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

std::string scriptOf(const std::string& engine, const cluster::Submission& submission) {
  if (engine == "parallel") return cluster::parallelScript(submission);
  return engine == "make" ? cluster::makeScript(submission) : cluster::slurmScript(submission);
}

void checkGrid(const SubmitOptions& options) {
  if (options.sweep && options.loop)
    throw core::usageError("--loop: not possible in a sweep, because each of its motions would change");
  if (!options.sweep && (options.grid.columns > 0 || !options.grid.labels.empty()))
    throw core::usageError("--columns and --label: need a grid, that is, -D with a range");
}

int submit(SubmitOptions options) {
  if (request::hasRanges(options.overrides)) options.sweep = options.grid;
  checkGrid(options);
  const RequestedFilm film = requestedFilm(options);
  const auto& [requested, target, frames] = film;
  const scene::Scene& scene = requested.scene;
  checkKind(target);
  checkMakeable(options, film, pictureOptions(options));
  // Throws here, instead of later in the queue, if the scene shows something that its motion lacks.
  if (!options.sweep) const stage::Stage stage(scene);
  const auto render = job::renderRequest(requested, target, frames, {.form = pictureOptions(options)});
  job::expectWithinMemory(render);
  const auto segments = request::segmentsOf(frames, options.parts.segmentFrames);
  cluster::Submission submission;
  submission.program = core::programPath();
  submission.folder = std::filesystem::current_path();
  submission.output = target;
  submission.render = renderWords(options, target);
  submission.assemble = assembleWords(options, target);
  submission.inputs = inputFiles(options, scene);
  submission.frames = frames.count();
  submission.segments = static_cast<std::int64_t>(segments.size());
  submission.division =
      cluster::divisionOf(divisionRequest(options), frames, segments, requested.size(), render.worker_bytes);
  submission.retries = options.retries;
  writeOut(scriptOf(options.engine, submission));
  return kDone;
}

void addDivisionOptions(const Command& command, SubmitOptions& options) {
  options.jobs = 1;
  command.option("--engine", options.engine, "slurm, parallel (GNU parallel) or make (default: slurm)")
      .type("NAME")
      .among({"slurm", "parallel", "make"});
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
  const Command command =
      program.command("submit", "print a script that makes a film on a cluster: for Slurm, GNU parallel or make");
  addSceneOptions(command, *options);
  addViewOption(command, *options);
  addLookOptions(command, *options);
  addFilmOptions(command, *options);
  addGridOptions(command, options->grid);
  addDivisionOptions(command, *options);
  command.footer(
      "submit starts nothing: it prints a script to read, change and run. The film has the same bytes as one\n"
      "from render --reproducible on one machine; with a range in -D, as one from sweep. If a task or the\n"
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
