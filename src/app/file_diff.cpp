// SPDX-License-Identifier: Apache-2.0
#include "app/file_diff.h"

#include "app/film_diff.h"
#include "image/png_file.h"
#include "output/film_reader.h"

namespace poinsot::app {
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
  if (!film.frames.empty() && film.frames[film.worst()].verdict != image::Verdict::kIdentical)
    forFrames(reference, test, {film.worst()}, request,
              [&](std::size_t, const ComparedPictures& frame) { compared = frame; });
  compared.diff = summaryOf(film);
  return compared;
}

/// A film beside a picture: nothing can be compared. @throws core::Error(kIo) if the picture cannot be read.
ComparedPictures unlikeKinds(const fs::path& picture, bool testIsFilm) {
  read(picture);
  ComparedPictures compared;
  compared.diff.mismatch = testIsFilm ? "the test is an animation, the reference is a single picture"
                                      : "the test is a single picture, the reference is an animation";
  return compared;
}

}  // namespace

ComparedPictures compareFiles(const fs::path& reference, const fs::path& test, const DiffRequest& request,
                              int jobs) {
  const bool film = output::isFilm(reference), testIsFilm = output::isFilm(test);
  if (film != testIsFilm) return unlikeKinds(film ? test : reference, testIsFilm);
  return film ? compareFilms(reference, test, request, jobs)
              : comparePictures(read(reference), read(test), request);
}

}  // namespace poinsot::app
