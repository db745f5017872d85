// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "output/film.h"

namespace poinsot::output {

/// Makes a GIF or an APNG of segments that keep every pixel as it is, as joinedSegments() has it.
core::AtomicFile animate(const std::vector<std::filesystem::path>& segments, const std::filesystem::path& target,
                         const FilmTrack& track, const FilmTexts& texts,
                         const std::filesystem::path& temporaryFolder);

}  // namespace poinsot::output
