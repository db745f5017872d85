// SPDX-License-Identifier: Apache-2.0
// The texts of films that libavformat writes none into: a GIF's comment, an APNG's text chunk, both at the end.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/film.h"

namespace poinsot::output {

/// What stands in place of the last `replaced` bytes of such a file, as libavformat leaves it.
struct AnimationEnd {
  std::size_t replaced = 0;
  std::vector<std::uint8_t> bytes;
};

/// With our mark and the texts. @pre a container for which isMadeWhole() holds.
AnimationEnd animationEnd(FilmContainer container, const std::vector<FilmText>& texts);

/// As readFilmFacts() of film.h, of a .gif or an .apng. @throws core::Error(kIo).
std::optional<FilmFacts> readAnimationFacts(const std::filesystem::path& file);

/// Whether it bears our mark, of whatever version.
bool isOwnAnimation(const std::filesystem::path& file);

}  // namespace poinsot::output
