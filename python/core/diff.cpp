// SPDX-License-Identifier: Apache-2.0
#include "diff.h"

#include <fmt/format.h>

#include <filesystem>
#include <variant>

#include "compare/diff_json.h"
#include "compare/file_diff.h"
#include "core/file_error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "output/film_reader.h"
#include "picture_source.h"
#include "signals.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

compare::DiffRequest requestOf(const DiffAsk& ask) {
  compare::DiffRequest request{ruleOf(ask.rule, ask.ignore), ask.pixelsPerDegree, {}, {}, {}};
  for (const std::string& word : ask.limits) request.limits.setByWord(word);
  if (ask.mask.is_none()) return request;
  Source mask = sourceOf(ask.mask);
  if (const auto* file = std::get_if<fs::path>(&mask))
    request.rule.mask = *file;
  else
    request.rule.painted = std::get<compare::DiffPicture>(std::move(mask)).pixels;
  return request;
}

bool isFilm(const Source& source) {
  const auto* file = std::get_if<fs::path>(&source);
  return file != nullptr && output::isFilm(*file);
}

compare::DiffPicture read(Source&& source) {
  if (auto* picture = std::get_if<compare::DiffPicture>(&source)) return std::move(*picture);
  image::PngPicture png = image::readPngAsStored(std::get<fs::path>(source));
  return {std::move(png.picture), png.stored, std::move(png.color)};
}

/// Throws if a file cannot be opened. Otherwise a missing film would pass, because isFilm() accepts its name.
void expectReadable(const Source& source) {
  const auto* file = std::get_if<fs::path>(&source);
  if (file == nullptr) return;
  try {
    core::bytesOf(core::openForReading(*file), 0, core::ErrorKind::kIo);
  } catch (const core::Error& error) {
    throw core::FileError(error.kind(), core::printable(file->native()) + ": " + error.message(), *file,
                          core::codeOf(error));
  }
}

std::string nameOf(const Source& source) {
  const auto* file = std::get_if<fs::path>(&source);
  return file != nullptr ? file->native() : "";
}

std::string comparedJson(Source reference, Source test, const compare::DiffRequest& request, int jobs) {
  for (const Source* source : {&reference, &test}) expectReadable(*source);
  const compare::DiffNames names{nameOf(reference), nameOf(test)};
  const bool film = isFilm(reference), testIsFilm = isFilm(test);
  if (film != testIsFilm)
    throw core::usageError(fmt::format("the {} is a film, but the {} is a picture: give two films or two pictures",
                                       film ? "reference" : "test", film ? "test" : "reference"));
  const auto expectOneSize = [](const std::string& mismatch, bool compared) {
    if (!compared && !mismatch.empty())
      throw core::usageError(mismatch + ": only pictures of the same size can be compared");
  };
  if (film) {
    const compare::FilmDiff diff = compare::diffFilms(names.reference, names.test, request, jobs);
    expectOneSize(diff.mismatch, !diff.frames.empty());
    return compare::diffJson(diff, names, request);
  }
  const compare::PictureDiff diff =
      compare::comparePictures(read(std::move(reference)), read(std::move(test)), request).diff;
  expectOneSize(diff.mismatch, diff.hasFigures);
  return compare::diffJson(diff, names, request);
}

}  // namespace

std::string diffJson(const PictureSource& reference, const PictureSource& test, const DiffAsk& ask) {
  Source a = sourceOf(reference), b = sourceOf(test);
  const compare::DiffRequest request = requestOf(ask);
  const WithoutGil others;
  return comparedJson(std::move(a), std::move(b), request, ask.jobs);
}

}  // namespace poinsot::python
