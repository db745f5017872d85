// SPDX-License-Identifier: Apache-2.0
#include "cli/film_options.h"

#include <optional>

#include "cli/command.h"
#include "cli/option_values.h"
#include "core/error.h"
#include "core/frame_clock.h"
#include "output/film_format.h"
#include "request/sweep_cells.h"
#include "scene/sweep.h"

namespace poinsot::cli {
void addFilmOptions(const Command& command, FilmOptions& options) {
  command
      .option("-o,--output", options.output,
              output::filmFormatsText() + ", NAME.png, NAME_{frame:05}.png, or - (default: out/SCENE.mp4)")
      .type("FILE")
      .notEmpty();
  command.option("--format", options.format, "format that -o - writes to standard output")
      .type("NAME")
      .notEmpty({"png", "mp4"});
  command.option("--frames", options.frames, "only these frames, both ends included").type("A-B").notEmpty();
  command.option("--fps", options.fps, "frames per second, such as 30 or 30000/1001").type("RATE").notEmpty();
  command
      .option(
          "--max-size", options.maxSize,
          "make a film of at most this size, such as 5MB: if necessary, with a smaller picture, fewer frames per "
          "second, and fewer colours or less quality")
      .type("SIZE")
      .notEmpty();
  command.flag("--transparent", options.transparent,
               "transparent background instead of paper, in .webm, .mov, .apng and PNG");
  addBitsOption(command, options.bits);
  command.flag("--loop", options.loop,
               "make a film that repeats without a jump: changes the start and the speed as little as possible, "
               "and prints by how much");
  command.option("--segment", options.parts.segmentFrames, "frames per segment (default: 30)")
      .type("N")
      .range(1, 10'000);
}

void addGridOptions(const Command& command, request::SweepRequest& grid) {
  command
      .option("--columns", grid.columns, "columns of the grid of one range (default: as many as fit the picture)")
      .type("N")
      .range(1, scene::kMostCells);
  command
      .option("--label", grid.labels,
              "label of a range's key in the picture, in TeX; the first label is for the first range")
      .type("TEX")
      .repeats()
      .notEmpty();
}

void addSeriesOption(const Command& command, FilmOptions& options) {
  command.flag(
      "--series", options.series,
      "make a film of its own for each value of the range in -D; {value} in the name stands for the value");
}

std::vector<request::SeriesFilm> seriesOf(const FilmOptions& options) {
  if (options.output.empty() || options.output == "-")
    throw core::usageError("--series: needs names for the films, such as -o 'films/{value}.mp4'");
  if (options.loop)
    throw core::usageError("--loop: not possible in a series, because each of its motions would change");
  if (!options.parts.manifest.empty() || !options.trace.empty())
    throw core::usageError("--manifest and --trace: describe one film, not a series");
  if (!options.maxSize.empty())
    throw core::usageError("--max-size: limits one film, not a series; make each film of the series by itself");
  return request::seriesOf(options.overrides, options.output);
}

std::vector<request::SeriesFilm> filmsOfShard(const std::vector<request::SeriesFilm>& films,
                                              const PartsOptions& parts) {
  const request::Shard shard = parts.shard.empty() ? request::Shard() : request::parseShard(parts.shard);
  std::vector<request::SeriesFilm> own;
  for (auto i = static_cast<std::size_t>(shard.k - 1); i < films.size(); i += static_cast<std::size_t>(shard.n))
    own.push_back(films[i]);
  return own;
}

void setFilm(FilmOptions& options, const request::SeriesFilm& film) {
  options.series = false;
  options.overrides = film.overrides;
  options.output = film.output;
  options.reproducible |= !options.parts.shard.empty() || options.parts.shardsLeft > 0;
  options.parts.shard.clear();
  options.parts.shardsLeft = 0;
  options.parts.resume = true;
}

void addPartsOptions(const Command& command, PartsOptions& parts) {
  command.flag("--resume", parts.resume,
               "continue a render of this output that stopped; frames that have changed are made again");
  command.flag("--keep", parts.keep, "keep the segments when the film is ready, for a later --resume");
  command
      .option("--manifest", parts.manifest,
              "also write a JSON file of all inputs, settings, digests of frames and files, and costs")
      .type("FILE")
      .notEmpty();
  command
      .option("--shard", parts.shard,
              "make only the segments of the k-th of n processes; join all segments with assemble")
      .type("k/n")
      .notEmpty();
  command
      .option("--shards-left", parts.shardsLeft,
              "make nothing: print which of n shards have segments to make, such as 2,7-9; exit code 0 if the "
              "output is complete, else 1")
      .type("n")
      .range(1, request::kMostShards);
}

void checkParts(const PartsOptions& parts, const request::OutputTarget& target) {
  if (!parts.shard.empty()) request::parseShard(parts.shard);
  const bool shards = !parts.shard.empty() || parts.shardsLeft > 0;
  if (!parts.shard.empty() && parts.shardsLeft > 0)
    throw core::usageError("--shards-left: covers all shards; leave out --shard");
  if (shards && !parts.manifest.empty())
    throw core::usageError("--manifest: describes a whole film, but a shard makes only a part of one");
  if (target.stream && (shards || !parts.manifest.empty() || parts.resume || parts.keep))
    throw core::usageError(
        "-o -: standard output cannot be read again; --resume, --keep, --shard and --manifest need a file");
  if (target.kind != request::OutputKind::kPicture) return;
  if (shards) throw core::usageError("--shard: one picture is made by one process");
  if (!parts.manifest.empty()) throw core::usageError("--manifest: possible only for a film or a sequence");
}

std::optional<request::OutputTarget> namedTarget(const FilmOptions& options) {
  if (options.output == "-") return request::streamTarget(options.format);
  if (!options.format.empty())
    throw core::usageError("--format: possible only with -o -; the extension of a file gives its format");
  return options.output.empty() ? std::nullopt : std::optional(request::parseTarget(options.output));
}

request::PictureOptions pictureOptions(const FilmOptions& options) {
  return {std::nullopt, options.transparent, options.bits};
}

FileAccess accessOf(const FilmOptions& options, const std::optional<request::OutputTarget>& target) {
  const RenderOptions& rendered = options;
  FileAccess access = accessOf(rendered, target);
  access.reproducible = options.reproducible || !options.maxSize.empty();
  access.outputs.push_back(options.parts.manifest);
  return access;
}

RequestedFilm requestedFilm(const FilmOptions& options) { return requestedFilm(options, granted(options)); }

RequestedFilm requestedFilm(const FilmOptions& options, const scene::Allowance& allowance) {
  const auto asked =
      options.frames.empty() ? std::nullopt : std::optional(request::parseFrameRange(options.frames));
  const auto named = namedTarget(options);
  checkBits(options.bits, named.value_or(request::OutputTarget{}));  // if no output is named, the output is a film
  auto requested = requestedScene(options, allowance);
  request::expectFilm(requested.request);
  const scene::Scene& scene = requested.scene;
  const auto target = named ? *named : request::parseTarget("out/" + scene.name + ".mp4");
  const auto frames = request::selectFrames(core::frameCount(scene.time.duration_s, scene.time.fps), asked);
  return {std::move(requested), target, frames};
}

}  // namespace poinsot::cli
