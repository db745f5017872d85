// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "output/film.h"

namespace poinsot::output {

/// Encodes a GIF or an APNG from lossless segments, in the given order.
/// @returns the complete film, which gets its name by commit().
core::AtomicFile animate(const std::vector<std::filesystem::path>& segments, const std::filesystem::path& target,
                         const FilmTrack& track, const FilmTexts& texts,
                         const std::filesystem::path& temporaryFolder);

}  // namespace poinsot::output
