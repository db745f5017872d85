// SPDX-License-Identifier: Apache-2.0
#include "cli/film_size.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/option_values.h"
#include "core/error.h"
#include "core/text.h"
#include "job/size_search.h"

namespace poinsot::cli {
namespace {

using job::FilmChoice;
using output::FilmContainer;

std::string nameOf(const FilmOptions& options) { return "--max-size " + core::printable(options.maxSize); }

void checkOptions(const FilmOptions& options, const request::OutputTarget& target) {
  const PartsOptions& parts = options.parts;
  if (target.kind != request::OutputKind::kFilm)
    throw core::usageError(
        fmt::format("{}: possible only for a film: {}", nameOf(options), output::filmFormatsText()));
  if (target.stream)
    throw core::usageError(
        fmt::format("{}: not possible with -o -, because bytes that were sent cannot be taken back; use a file",
                    nameOf(options)));
  if (parts.resume || parts.keep || !parts.shard.empty() || parts.shardsLeft > 0)
    throw core::usageError(fmt::format(
        "{}: not possible with --resume, --keep, --shard and --shards-left, because trial films leave no "
        "segments; first make the film without them, and then use the options that it prints",
        nameOf(options)));
}

/// Returns whether -D sets the key, or its whole table.
bool sets(const FilmOptions& options, std::string_view key) {
  return std::ranges::any_of(options.overrides, [&](std::string_view text) {
    std::string_view name = text.substr(0, text.find('='));
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    return name == key || (key.starts_with(name) && key.substr(name.size()).starts_with('.'));
  });
}

/// Returns what the user has fixed. With --frames, the rate is fixed, because another rate gives the numbers of
/// the frames another meaning.
job::FixedProperties fixedBy(const FilmOptions& options) {
  const bool quality = !options.quality.empty() || sets(options, "output.quality");
  return {.size = quality || !options.size.empty() || sets(options, "output.size"),
          .fps = !options.fps.empty() || !options.frames.empty() || sets(options, "time.fps"),
          .colors = sets(options, "output.colors"),
          .crf = quality || sets(options, "output.crf")};
}

FilmChoice choiceOf(const scene::Scene& scene) {
  const scene::Output& output = scene.output;
  return {{output.width, output.height}, scene.time.fps, output.colors, output.crf};
}

std::string sizeText(image::PixelSize size) { return fmt::format("{}x{}", size.width, size.height); }

/// Returns a film in words, such as "640x360, 12.5 frames/s, 64 colours".
std::string textOf(const FilmChoice& film, FilmContainer container) {
  std::string text = fmt::format("{}, {:g} frames/s", sizeText(film.size), film.fps.value());
  if (container == FilmContainer::kGif) text += fmt::format(", {} colours", film.colors);
  if (container == FilmContainer::kMp4 || container == FilmContainer::kWebm)
    text += fmt::format(", crf {}", film.crf);
  return text;
}

/// Returns a frame rate as the user types it, such as "25" or "25/2".
std::string rateText(const core::Rational& fps) {
  return fps.den == 1 ? fmt::format("{}", fps.num) : core::toString(fps);
}

/// Sets the options that turn the film as asked into another film. With --reproducible, films have the same size
/// on every machine, and so the choice is the same.
/// @returns these options as the user types them, such as " --size 640x360 --fps 15"
std::string choose(FilmOptions& options, const FilmChoice& asked, const FilmChoice& film) {
  std::string typed;
  if (film.size != asked.size) typed += " --size " + (options.size = sizeText(film.size));
  if (film.fps != asked.fps) typed += " --fps " + (options.fps = rateText(film.fps));
  const auto override = [&](std::string_view key, int value) {
    options.overrides.push_back(fmt::format("{}={}", key, value));
    typed += " -D " + options.overrides.back();
  };
  if (film.colors != asked.colors) override("output.colors", film.colors);
  if (film.crf != asked.crf) override("output.crf", film.crf);
  if (!options.reproducible) typed += " --reproducible";
  options.reproducible = true;
  return typed;
}

std::string adviceOn(const job::FixedProperties& fixed, FilmContainer container) {
  std::vector<std::string_view> names;
  if (fixed.size) names.emplace_back("size");
  if (fixed.fps) names.emplace_back("frame rate");
  if (fixed.colors && container == FilmContainer::kGif) names.emplace_back("colours");
  if (fixed.crf && (container == FilmContainer::kMp4 || container == FilmContainer::kWebm))
    names.emplace_back("quality");
  return names.empty() ? "" : fmt::format(", do not fix its {}", core::joined(names, ", "));
}

[[noreturn]] void refuse(const FilmOptions& options, const job::MeasuredFilm& smallest,
                         const job::FixedProperties& fixed, FilmContainer container) {
  throw core::limitError(
      fmt::format("{}: not possible; the smallest film has {} ({} bytes: {}); make the film shorter (-D "
                  "time.duration=...){}, or "
                  "allow --max-size {}kB",
                  nameOf(options), fileSizeText(smallest.bytes), smallest.bytes, textOf(smallest.film, container),
                  adviceOn(fixed, container), (smallest.bytes + 999) / 1000));
}

int describeOnly(FilmOptions options, RequestedFilm film) {
  options.reproducible = true;
  const int status = renderTo(options, std::move(film), {.form = pictureOptions(options)}, options.parts);
  if (printsNotes(options))
    writeErr(
        fmt::format("poinsot: {}: the film may get a smaller picture, fewer frames per second, and fewer colours "
                    "or less quality; only trial films show which\n",
                    nameOf(options)));
  return status;
}

std::string chosenText(const FilmOptions& options, const std::string& film, const std::string& typed) {
  return fmt::format("poinsot: {}: {}; to make this film again, {}\n", nameOf(options), film,
                     typed.empty() ? "leave out --max-size" : "replace --max-size by" + typed);
}

int search(const FilmOptions& options, const RequestedFilm& film, std::int64_t most_bytes) {
  const FilmContainer container = *output::filmContainer(film.target.path);
  const job::FixedProperties fixed = fixedBy(options);
  const FilmChoice asked = choiceOf(film.scene.scene);
  job::SizeSearch search(asked, container, fixed, most_bytes);
  while (const auto trial = search.next()) {
    FilmOptions chosen = options;
    const std::string typed = choose(chosen, asked, trial->film);
    const auto made = renderWithin(chosen, requestedFilm(chosen, allowed(chosen)),
                                   {.form = pictureOptions(chosen), .accepted = trial->accepted}, chosen.parts);
    const std::string found = fmt::format("{}: {} ({} bytes)", textOf(trial->film, container),
                                          fileSizeText(made.film_bytes), made.film_bytes);
    if (printsNotes(options))
      writeErr(made.written ? chosenText(options, found, typed) : fmt::format("poinsot: tried {}\n", found));
    if (made.written) return kDone;
    search.add(made.film_bytes);
  }
  refuse(options, search.smallest(), fixed, container);
}

}  // namespace

int makeFilm(const FilmOptions& options, RequestedFilm film) {
  checkParts(options.parts, film.target);
  if (options.maxSize.empty())
    return renderTo(options, std::move(film), {.form = pictureOptions(options)}, options.parts);
  checkOptions(options, film.target);
  const std::int64_t most_bytes = parseFileSize_bytes("--max-size", options.maxSize);
  return options.dryRun ? describeOnly(options, std::move(film)) : search(options, film, most_bytes);
}

}  // namespace poinsot::cli
