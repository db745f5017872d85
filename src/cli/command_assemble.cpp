// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/error.h"
#include "core/text.h"
#include "job/work_folder.h"
#include "job/work_left.h"
#include "output/run_files.h"
#include "request/subtitles.h"

namespace poinsot::cli {
namespace {

struct AssembleOptions {
  std::string output, film;
  bool force = false, keep = false, quiet = false;
};

request::OutputTarget filmTarget(const AssembleOptions& options, const request::OutputTarget& output) {
  if (options.film.empty()) return output;
  const auto film = request::parseTarget(options.film);
  if (film.kind != output.kind || output.kind != request::OutputKind::kFilm)
    throw core::usageError("-o: possible only for a film; numbered frames stay where they are");
  if (film.path.extension() != output.path.extension())
    throw core::usageError(
        fmt::format("-o {}: the segments belong to a {} film; choose a name with the same extension",
                    core::printable(options.film), core::printable(output.path.extension().string())));
  return film;
}

void enterFiles(const AssembleOptions& options, const std::filesystem::path& folder, const job::JobRecord& job,
                const request::OutputTarget& film) {
  output::RunFiles files(options.force);
  for (const request::FrameRange& segment : job.segments())
    files.reads(job::segmentFile(folder, job.film.container, segment), "segment");
  files.writes(film.path, "-o");
  request::enterSubtitles(files, job.subtitles, film.path);
}

int assemble(const AssembleOptions& options) {
  const auto output = request::parseTarget(options.output), film = filmTarget(options, output);
  const auto folder = job::workFolderOf(output.path);
  const auto job = job::readJobRecord(folder, output);
  if (!job)
    throw core::ioError(fmt::format("{}: no segments found; {}", core::printable(options.output),
                                    job::nothingUnderWayText(output, folder)));
  if (film.kind == request::OutputKind::kFilm) enterFiles(options, folder, *job, film);
  job::WorkFolder work(output.path, job::WorkFolderUse::kResumed);
  core::FileBatch results;
  job::assemble(results, work.path(), *job, output, film.path);
  results.commit();
  if (!options.keep) work.discard();
  if (!options.quiet)
    writeErr(fmt::format("poinsot: {} is ready ({} frames)\n", core::printable(film.path.string()),
                         job->frames.count()));
  return kDone;
}

}  // namespace

void addAssemble(const Command& program) {
  auto options = std::make_shared<AssembleOptions>();
  const Command command =
      program.command("assemble", "join the segments that shards have made; fails if frames are missing");
  command.option("OUTPUT", options->output, "the output that the shards were given with -o").required();
  command.option("-o,--output", options->film, "another name for the film").type("FILE");
  command.flag("--force", options->force, "replace a file that this program did not write");
  command.flag("--keep", options->keep, "keep the segments");
  command.flag("--quiet", options->quiet, "print only errors");
  command.footer(
      "Examples:\n"
      "  poinsot render scenes/football.toml -o out/football.mp4 --shard 1/2\n"
      "  poinsot render scenes/football.toml -o out/football.mp4 --shard 2/2    # for example on another machine\n"
      "  poinsot assemble out/football.mp4");
  command.does({[options] { return assemble(*options); }});
}

}  // namespace poinsot::cli
