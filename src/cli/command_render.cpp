// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/frame_plan.h"
#include "cli/commands.h"
#include "cli/film_options.h"
#include "core/error.h"
#include "core/text.h"

namespace poinsot::cli {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw core::Error(core::ErrorKind::kUsage, message); }

void checkFrameCount(const app::OutputTarget& target, const app::FrameRange& frames) {
  if (target.kind != app::OutputKind::kPicture || frames.count() == 1) return;
  refuse(
      fmt::format("{0} takes one frame, and {1} are selected: choose one with --frames {2}, or number them as "
                  "NAME_{{frame:05}}.png",
                  core::printable(target.path.string()), frames.count(), frames.first));
}

void checkParts(const PartsOptions& parts, const app::OutputTarget& target) {
  if (!parts.shard.empty()) app::parseShard(parts.shard);
  if (!parts.shard.empty() && !parts.manifest.empty())
    refuse("--manifest: tells of a whole film, and a shard makes a part of one");
  if (target.stream && (!parts.shard.empty() || !parts.manifest.empty() || parts.resume || parts.keep))
    refuse("-o -: what went to standard output is gone; --resume, --keep, --shard and --manifest are for files");
  if (target.kind != app::OutputKind::kPicture) return;
  if (!parts.shard.empty()) refuse("--shard: one picture is made by one process");
  if (!parts.manifest.empty()) refuse("--manifest: is of a film or a sequence");
}

void addPartsOptions(CLI::App& command, PartsOptions& parts) {
  command.add_flag("--resume", parts.resume,
                   "go on where a render of this output stopped; what has changed is made again");
  command.add_flag("--keep", parts.keep, "keep the segments when the film is ready, for a later --resume");
  command
      .add_option("--manifest", parts.manifest,
                  "besides, a JSON file of all inputs, settings, digests of frames and files, and costs")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      .add_option("--shard", parts.shard,
                  "only the segments of the k-th of n processes; then join them with assemble")
      ->type_name("k/n")
      ->check(notEmpty());
}

Reach reachOf(const FilmOptions& options) {
  Reach reach = reachOf(options, namedTarget(options));
  reach.outputs.push_back(options.parts.manifest);
  return reach;
}

int render(const FilmOptions& options) {
  auto film = requestedFilm(options);
  checkFrameCount(film.target, film.frames);
  checkParts(options.parts, film.target);
  return renderTo(options, film.target, std::move(film.request), film.scene, film.frames, std::nullopt,
                  pictureForm(options), options.parts);
}

}  // namespace

void addRender(CLI::App& program, Action& chosen) {
  auto options = std::make_shared<FilmOptions>();
  CLI::App* command = program.add_subcommand("render", "make a film, a frame or a numbered sequence from a scene");
  addRenderOptions(*command, *options);
  addFilmOptions(*command, *options);
  addPartsOptions(*command, options->parts);
  command->footer(
      "Examples:\n"
      "  poinsot render scenes/tennis_racket.toml -o out/tennis_racket.mp4\n"
      "  poinsot render scenes/football.toml -q preview -D time.duration=4\n"
      "  poinsot render scenes/football.toml -o - --format png | ffmpeg -f image2pipe -i - ...\n"
      "  poinsot render scenes/football.toml --frames 0-59 -o 'out/frames/football_{frame:05}.png'");
  command->callback([options, &chosen] {
    chosen = [options] {
      return confined(
          *options, [&] { return reachOf(*options); }, [&] { return render(*options); });
    };
  });
}

}  // namespace poinsot::cli
