// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/film_options.h"

namespace poinsot::cli {

/// Makes the film or sequence of `render` or `sweep`. With --max-size, searches for the best film that is not
/// larger.
/// @param film  result of requestedFilm()
/// @returns an exit code
/// @throws core::Error(kUsage) for options that are not allowed together; core::Error(kLimit) if even the smallest
///   film is larger than --max-size; otherwise like renderTo()
int makeFilm(const FilmOptions& options, RequestedFilm film);

}  // namespace poinsot::cli
