// SPDX-License-Identifier: Apache-2.0
#include "compare/file_diff.h"

#include "compare/film_diff.h"
#include "image/png_file.h"
#include "output/film_reader.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;

DiffPicture read(const fs::path& file) {
  image::PngPicture png = image::readPngAsStored(file);
  return {std::move(png.picture), png.stored, std::move(png.color)};
}

ComparedPictures compareFilms(const fs::path& reference, const fs::path& test, const DiffRequest& request,
                              int jobs) {
  const FilmDiff film = diffFilms(reference, test, request, jobs);
  ComparedPictures compared;
  PictureDiff summary = summaryOf(film);
  if (!film.frames.empty() && summary.verdict != Verdict::kIdentical)
    forFrames(reference, test, {film.worst()}, request,
              [&](std::size_t, const ComparedPictures& frame) { compared = frame; });
  summary.ignored = compared.diff.ignored;
  compared.diff = std::move(summary);
  return compared;
}

/// Returns the result for a film and a single picture, which never match.
/// @throws core::Error(kIo) if the picture cannot be read
ComparedPictures unlikeKinds(const fs::path& picture, bool testIsFilm) {
  read(picture);
  ComparedPictures compared;
  compared.diff.mismatch = testIsFilm ? "the test is an animation, the reference is a single picture"
                                      : "the test is a single picture, the reference is an animation";
  return compared;
}

}  // namespace

PictureDiff unreadablePair(const core::Error& error) {
  PictureDiff diff;
  diff.isReadable = false;
  diff.mismatch = error.what();
  return diff;
}

ComparedPictures compareFiles(const fs::path& reference, const fs::path& test, const DiffRequest& request,
                              int jobs) {
  const bool film = output::isFilm(reference), testIsFilm = output::isFilm(test);
  if (film != testIsFilm) return unlikeKinds(film ? test : reference, testIsFilm);
  return film ? compareFilms(reference, test, request, jobs)
              : comparePictures(read(reference), read(test), request);
}

}  // namespace poinsot::compare
