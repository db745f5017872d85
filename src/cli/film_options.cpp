// SPDX-License-Identifier: Apache-2.0
#include "cli/film_options.h"

#include <CLI/CLI.hpp>
#include <optional>

#include "app/frame_clock.h"
#include "output/film_format.h"

namespace poinsot::cli {

void addFilmOptions(CLI::App& command, FilmOptions& options) {
  command
      .add_option("-o,--output", options.output,
                  output::filmFormatsText() + ", NAME.png or NAME_{frame:05}.png (default: out/SCENE.mp4)")
      ->type_name("FILE")
      ->check(notEmpty());
  command.add_option("--frames", options.frames, "only these frames, both ends included")
      ->type_name("A-B")
      ->check(notEmpty());
  command.add_option("--fps", options.fps, "frames per second, such as 30 or 30000/1001")
      ->type_name("RATE")
      ->check(notEmpty());
  command.add_flag("--transparent", options.transparent,
                   "no paper behind the pictures: .webm, .mov, .apng and PNG");
  command.add_flag(
      "--loop", options.loop,
      "a film that repeats without a jump: changes the start and the speed least, and says by how much");
  command.add_option("--segment", options.parts.segmentFrames, "frames of a segment (default: 30)")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000));
}

RequestedFilm requestedFilm(const FilmOptions& options) {
  const auto asked = options.frames.empty() ? std::nullopt : std::optional(app::parseFrameRange(options.frames));
  if (!options.output.empty()) app::parseTarget(options.output);  // a wrong name is said before all else
  auto [request, scene] = requestedScene(options);
  const auto target = requestedTarget(options, scene.name, ".mp4");
  const auto frames = app::selectFrames(app::frameCount(scene.time.duration_s, scene.time.fps), asked);
  return {std::move(request), std::move(scene), target, frames};
}

}  // namespace poinsot::cli
