// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/rendering.h"

namespace poinsot::cli {

/// Words of the command line common to all that make films, as typed.
struct FilmOptions : RenderOptions {
  std::string frames, format;
  bool transparent = false;
  int bits = 8;
  PartsOptions parts;
};

/// Declares the output, the frames and their rate, --loop, and --segment.
void addFilmOptions(const Command& command, FilmOptions& options);

/// Declares how it is made in parts: --resume, --keep, --manifest, --shard.
void addPartsOptions(const Command& command, PartsOptions& parts);

/// Declares the columns and names of a sweep's grid.
void addGridOptions(const Command& command, request::SweepRequest& grid);

/// @throws core::Error(kUsage) for what the target cannot be made in.
void checkParts(const PartsOptions& parts, const request::OutputTarget& target);

/// Where it goes, as far as the options alone tell: a wrong name is said before all else.
/// @throws core::Error(kUsage)
std::optional<request::OutputTarget> namedTarget(const FilmOptions& options);

/// How its pictures are made.
request::PictureOptions pictureOptions(const FilmOptions& options);

/// @throws scene::SceneErrors, core::Error
RequestedFilm requestedFilm(const FilmOptions& options);

}  // namespace poinsot::cli
