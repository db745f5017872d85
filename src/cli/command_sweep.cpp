// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/dry_run.h"
#include "cli/exit_code.h"
#include "cli/film_options.h"
#include "cli/film_size.h"
#include "cli/option_values.h"
#include "cli/still_options.h"
#include "core/error.h"
#include "core/text.h"
#include "job/work_left.h"
#include "output/film_format.h"
#include "output/frame_pattern.h"
#include "request/sweep_cells.h"
#include "scene/sweep.h"

namespace poinsot::cli {
namespace {

struct SweepOptions : FilmOptions {
  StillOptions still;
  request::SweepRequest asked;
};

/// Returns whether the name of the output is a film or sequence. Without a name, the output is a picture.
bool isFilm(const SweepOptions& options) {
  return options.output == "-" || output::filmContainer(options.output).has_value() ||
         output::FramePattern::isPattern(options.output);
}

request::OutputTarget pictureTarget(const SweepOptions& options, const std::string& sceneName) {
  const std::string ofItself = "out/" + sceneName + (options.asked.map ? "_map.png" : "_sweep.png");
  return request::parseStillTarget(options.output.empty() ? ofItself : options.output);
}

bool setsInstant(const std::string& override) {
  return core::trimmed(std::string_view(override).substr(0, override.find('='))) == scene::kInstantKey;
}

void checkTimes(const SweepOptions& options) {
  if (options.times.empty()) return;
  instantsOverride(options.times);  // throws for wrong times, before the scene is read
  if (options.still.time)
    throw core::usageError("--times and --time: give only one of them; --times gives each cell its own time");
  if (std::ranges::any_of(options.overrides, setsInstant))
    throw core::usageError(
        fmt::format("--times and -D {}: give only one of them; both set the time of a cell", scene::kInstantKey));
  if (options.series || options.asked.map)
    throw core::usageError(
        fmt::format("--times: makes a sheet of one scene; leave out {}", options.series ? "--series" : "--map"));
  if (isFilm(options))
    throw core::usageError(
        "--times: a sheet of several instants is one picture, not a film; use -o NAME.png, NAME.pdf, NAME.svg or "
        "NAME.tex");
}

void checkWords(const SweepOptions& options) {
  const PartsOptions& parts = options.parts;
  if (isFilm(options)) {
    if (options.asked.map)
      throw core::usageError(
          "--map: a map is one picture, not a film; use -o NAME.png, NAME.pdf, NAME.svg or NAME.tex");
    if (options.still.any())
      throw core::usageError("--time, --width, --dpi and --type are for one picture, not for a film");
    if (options.still.svgText)
      throw core::usageError("--svg-text: possible only for a figure NAME.svg, not a film");
    return;
  }
  if (!options.frames.empty() || !options.format.empty() || !options.maxSize.empty() || parts.resume ||
      parts.keep || !parts.shard.empty() || parts.shardsLeft > 0 || !parts.manifest.empty())
    throw core::usageError(
        "--frames, --format, --max-size, --resume, --keep, --shard and --manifest are for films; for one picture, "
        "use "
        "--time");
  if (options.asked.map && (options.asked.columns > 0 || !options.asked.labels.empty()))
    throw core::usageError("--columns and --label are for a grid, not for --map");
}

void checkSeries(const SweepOptions& options) {
  if (!options.series && request::isSeriesName(options.output))
    throw core::usageError("-o: {value} stands for a value in the names of a series; add --series");
  if (options.series && (options.asked.map || options.asked.columns > 0 || !options.asked.labels.empty()))
    throw core::usageError("--series: makes films of one motion each; leave out --map, --columns and --label");
}

int makeOne(const SweepOptions& options) {
  if (isFilm(options)) return makeFilm(options, requestedFilm(options));
  return makeStill(options, options.still, pictureOptions(options),
                   [&](const std::string& sceneName) { return pictureTarget(options, sceneName); });
}

/// Returns the options of each film of a series, or of the shard's films.
std::vector<SweepOptions> filmsOf(const SweepOptions& options) {
  const auto all = seriesOf(options);
  SweepOptions first = options;
  first.output = all.front().output;
  checkWords(first);
  std::vector<SweepOptions> films;
  for (const request::SeriesFilm& film : filmsOfShard(all, options.parts)) {
    films.push_back(options);
    setFilm(films.back(), film);
  }
  return films;
}

/// Prints the shards that have films to make. @returns kDone if all films exist, else kNo
int listSeriesLeft(const SweepOptions& options) {
  std::set<int> left;
  int number = 0;
  for (const SweepOptions& film : filmsOf(options)) {
    const int shard = number++ % options.parts.shardsLeft + 1;
    if (!left.contains(shard) &&
        !isComplete(renderOf(film, requestedFilm(film), {.form = pictureOptions(film)}, film.parts)))
      left.insert(shard);
  }
  if (left.empty())
    writeErr(fmt::format("poinsot: all {} films are complete\n", number));
  else
    writeOut(job::shardsText({left.begin(), left.end()}) + "\n");
  return left.empty() ? kDone : kNo;
}

/// Makes the films of a series, one after the other. All scenes are read first, so that an error in one of them is
/// reported before the first film is made.
int makeSeries(const SweepOptions& options) {
  const std::vector<SweepOptions> films = filmsOf(options);
  for (const SweepOptions& film : films) requestedScene(film);
  for (const SweepOptions& film : films)
    if (const int status = makeOne(film); status != kDone) return status;
  return kDone;
}

int sweep(SweepOptions options) {
  checkTimes(options);
  checkSeries(options);
  if (options.series) return options.parts.shardsLeft > 0 ? listSeriesLeft(options) : makeSeries(options);
  checkWords(options);
  options.sweep = options.asked;
  return makeOne(options);
}

FileAccess accessOf(const SweepOptions& options) {
  return accessOf(options,
                  isFilm(options) ? namedTarget(options) : std::optional(pictureTarget(options, "SCENE")));
}

FileAccess accessOfAll(const SweepOptions& options) {
  if (!options.series) return accessOf(options);
  FileAccess all;
  for (const SweepOptions& film : filmsOf(options)) {
    FileAccess one = accessOf(film);
    one.outputs.insert(one.outputs.end(), all.outputs.begin(), all.outputs.end());
    all = std::move(one);
  }
  return all;
}

}  // namespace

void addSweep(const Command& program) {
  auto options = std::make_shared<SweepOptions>();
  const Command command =
      program.command("sweep", "draw a scene with several values of a key side by side, or its stability map");
  addRenderOptions(command, *options);
  addFilmOptions(command, *options);
  command.declared("--output")
      .help(output::filmFormatsText() +
            ", NAME_{frame:05}.png, or - for a film of all cells on one clock; NAME.png, NAME.pdf, NAME.svg or "
            "NAME.tex for a sheet or a map (default: out/SCENE_sweep.png, out/SCENE_map.png)");
  command.remove("--loop");  // removed, because --loop would change each motion separately
  addPartsOptions(command, options->parts);
  addStillOptions(command, options->still);
  command
      .option("--times", options->times,
              "film times of a sheet of one scene, one cell each, such as 0,0.9,1.8 or 0..3.6:5; each cell is "
              "labelled with the time of the motion")
      .type("T1,T2,...")
      .notEmpty();
  command.flag("--map", options->asked.map,
               "instead of the grid, draw the sphere of directions of L in the body, coloured by the time from "
               "flip to flip, with the separatrix");
  addGridOptions(command, options->asked);
  addSeriesOption(command, *options);
  command.footer(
      "A range is FROM..TO:COUNT, both ends included, with a unit if the key has one; append :log for equal "
      "ratios. 1|2|5 is a list of single values. One range fills rows; with two ranges, the first runs from left "
      "to right and the second from top to bottom.\n"
      "Examples:\n"
      "  poinsot sweep scenes/tennis_racket.toml -D 'motion.omega_body=[0.01..0.41:9, 4.2, 0]' -o out/grid.mp4\n"
      "  poinsot sweep scenes/football.toml -D 'time.start=0..2 s:6' -o out/sheet.pdf\n"
      "  poinsot sweep scenes/football.toml --times 0,0.4,0.8 -o out/instants.pdf\n"
      "  poinsot sweep scenes/tennis_racket.toml --map -o out/map.pdf\n"
      "  poinsot sweep scenes/football.toml --series -D 'time.start=0..2 s:3' -o 'out/football_{value}.mp4'");
  command.does(
      {[options] { return sweep(*options); }, options.get(), [options] { return accessOfAll(*options); }});
}

}  // namespace poinsot::cli
