// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/film_options.h"
#include "cli/film_size.h"
#include "core/error.h"
#include "core/text.h"
#include "request/frame_plan.h"

namespace poinsot::cli {
namespace {

void checkFrameCount(const request::OutputTarget& target, const request::FrameRange& frames) {
  if (target.kind != request::OutputKind::kPicture || frames.count() == 1) return;
  throw core::usageError(
      fmt::format("{0} takes one frame, and {1} are selected: choose one with --frames {2}, or number them as "
                  "NAME_{{frame:05}}.png",
                  core::printable(target.path.string()), frames.count(), frames.first));
}

int render(const FilmOptions& options) {
  auto film = requestedFilm(options);
  checkFrameCount(film.target, film.frames);
  return makeFilm(options, std::move(film));
}

}  // namespace

void addRender(const Command& program) {
  auto options = std::make_shared<FilmOptions>();
  const Command command = program.command("render", "make a film, a frame or a numbered sequence from a scene");
  addRenderOptions(command, *options);
  addFilmOptions(command, *options);
  addPartsOptions(command, options->parts);
  command.footer(
      "Examples:\n"
      "  poinsot render scenes/tennis_racket.toml -o out/tennis_racket.mp4\n"
      "  poinsot render scenes/football.toml -q preview -D time.duration=4\n"
      "  poinsot render scenes/football.toml --fps 25 --max-size 5MB -o out/football.gif\n"
      "  poinsot render scenes/football.toml -o - --format png | ffmpeg -f image2pipe -i - ...\n"
      "  poinsot render scenes/football.toml --frames 0-59 -o 'out/frames/football_{frame:05}.png'");
  command.does({[options] { return render(*options); }, options.get(),
                [options] { return accessOf(*options, namedTarget(*options)); }});
}

}  // namespace poinsot::cli
