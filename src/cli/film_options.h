// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/rendering.h"
#include "request/film_series.h"

namespace poinsot::cli {

/// Options of the commands that make films, as the user typed them.
struct FilmOptions : RenderOptions {
  std::string frames, format;
  std::string maxSize;  ///< largest size of the film's file; empty for any size
  bool transparent = false, series = false;
  int bits = 8;
  PartsOptions parts;
};

/// Declares -o, the options for frames and their rate, --max-size, --transparent, --bits, --loop and --segment.
void addFilmOptions(const Command& command, FilmOptions& options);

/// Declares --resume, --keep, --manifest, --shard and --shards-left.
void addPartsOptions(const Command& command, PartsOptions& parts);

void addGridOptions(const Command& command, request::SweepRequest& grid);

/// Declares --series.
void addSeriesOption(const Command& command, FilmOptions& options);

/// Returns the films of --series.
/// @throws core::Error(kUsage) like request::seriesOf(), and for options that have no meaning in a series
std::vector<request::SeriesFilm> seriesOf(const FilmOptions& options);

/// Returns every n-th film, beginning with the k-th, for --shard k/n. Without --shard, returns all films.
std::vector<request::SeriesFilm> filmsOfShard(const std::vector<request::SeriesFilm>& films,
                                              const PartsOptions& parts);

/// Turns the options of a series into those of one of its films. A film that exists is not made again.
void setFilm(FilmOptions& options, const request::SeriesFilm& film);

/// Rejects options that are not allowed for the target. @throws core::Error(kUsage)
void checkParts(const PartsOptions& parts, const request::OutputTarget& target);

/// Returns the target if the user named one. Call before the scene is read, so that a wrong name is reported
/// first.
/// @throws core::Error(kUsage)
std::optional<request::OutputTarget> namedTarget(const FilmOptions& options);

request::PictureOptions pictureOptions(const FilmOptions& options);

/// Returns the files that a command for films reads and writes.
FileAccess accessOf(const FilmOptions& options, const std::optional<request::OutputTarget>& target);

/// Reads the scene, and determines the target and the frames. @throws scene::SceneErrors, core::Error
RequestedFilm requestedFilm(const FilmOptions& options);
/// Reads a scene with the given limits. @param allowance  result of granted() or allowed()
RequestedFilm requestedFilm(const FilmOptions& options, const scene::Allowance& allowance);

}  // namespace poinsot::cli
