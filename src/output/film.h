// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poinsot::output {

/// A text kept in the film: "title", "comment", "description", ...
struct FilmText {
  std::string key;
  std::string value;
};

/// Joins segments written by VideoSegmentWriter, in this order, into one MP4: the encoded pictures as they are,
/// one after the other at the segments' frame rate, with the index first (a player can start before it has all).
/// The same segments give the same bytes. The film appears under its name only when complete and synced.
/// @throws core::Error(kIo) naming the file: unreadable or damaged, or made with other settings than the first
/// (size,
///         frame rate, encoder header); or the film cannot be written.
/// `temporaryFolder`: as of AtomicFile.
void joinSegments(const std::vector<std::filesystem::path>& segments, const std::filesystem::path& target,
                  const std::vector<FilmText>& texts = {}, const std::filesystem::path& temporaryFolder = {});

/// What a film tells of itself.
struct FilmFacts {
  std::int64_t frames = 0;
  std::string comment;
};

/// Of a film written by this version of the program that is there to its last frame; nothing of any other file.
std::optional<FilmFacts> readFilmFacts(const std::filesystem::path& film);

/// Whether the file is an MP4 written by this program. False for whatever cannot be read.
bool isOwnFilm(const std::filesystem::path& path);

}  // namespace poinsot::output
