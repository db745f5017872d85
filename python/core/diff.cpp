// SPDX-License-Identifier: Apache-2.0
#include "diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "compare/diff_json.h"
#include "compare/file_diff.h"
#include "core/file_error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "output/film_reader.h"
#include "signals.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

template <class Sample>
image::BasicImage<Sample> expanded(const Sample* samples, image::PixelSize size, int channels) {
  const bool grey = channels < 3, alpha = channels % 2 == 0;
  image::BasicImage<Sample> picture(size, alpha ? 4 : 3);
  if (!grey) {
    std::copy_n(samples, picture.pixels.size(), picture.pixels.begin());
    return picture;
  }
  auto next = picture.pixels.begin();
  const std::size_t pixels = picture.pixels.size() / (alpha ? 4 : 3);
  for (std::size_t i = 0; i < pixels; ++i) {
    next = std::fill_n(next, 3, *samples++);
    if (alpha) *next++ = *samples++;
  }
  return picture;
}

template <class Sample>
compare::DiffPicture pictureOf(const py::array& array) {
  const auto samples = py::array_t<Sample, py::array::c_style>::ensure(array);
  const auto side = [&](py::ssize_t axis) { return static_cast<int>(array.shape(axis)); };
  const int channels = side(2);
  return {expanded(samples.data(), {side(1), side(0)}, channels), {channels, false, sizeof(Sample) == 2}};
}

using Source = std::variant<fs::path, compare::DiffPicture>;

Source sourceOf(const PictureSource& source) {
  if (py::isinstance<py::bytes>(source)) return fs::path(py::cast<std::string>(source));
  const auto array = py::cast<py::array>(source);
  return array.itemsize() == 2 ? pictureOf<std::uint16_t>(array) : pictureOf<std::uint8_t>(array);
}

compare::NearRule limitsOf(const DiffAsk& ask) {
  compare::NearRule limits;
  for (const auto& [key, word] : ask.rule)
    if (key == "like") limits = compare::namedLimits("rule", word);
  for (const auto& [key, word] : ask.rule) {
    if (key == "like") continue;
    const auto known = std::ranges::find(compare::ruleLimits(), std::string_view(key), &compare::RuleLimit::key);
    if (known == compare::ruleLimits().end()) {
      std::vector<std::string_view> keys{"like"};
      for (const compare::RuleLimit& limit : compare::ruleLimits()) keys.emplace_back(limit.key);
      throw core::usageError(
          fmt::format("rule: unknown key '{}'; the keys are {}", core::printable(key), core::joined(keys, ", ")));
    }
    known->set(limits, "rule: " + key, word);
  }
  compare::expectCanRefuse(limits, "rule");
  return limits;
}

compare::DiffRequest requestOf(const DiffAsk& ask) {
  compare::DiffRequest request{{limitsOf(ask)}, ask.pixelsPerDegree, {}, {}, {}};
  for (const std::vector<double>& box : ask.ignore)
    request.rule.ignore.push_back(compare::ignoredBox("ignore", box));
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
