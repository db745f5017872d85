// SPDX-License-Identifier: Apache-2.0
#include "compare/picture_diff.h"

#include <fmt/format.h>

#include <variant>

#include "compare/common_form.h"
#include "compare/magma.h"
#include "compare/memory.h"
#include "core/text.h"
#include "request/memory.h"

namespace poinsot::compare {
namespace {

constexpr const char* kMapKey = "Comparison";  // key of the PNG text that identifies maps

image::PixelSize sizeOf(const image::AnyImage& picture) {
  return std::visit([](const auto& p) { return p.size; }, picture);
}

bool hasAlpha(const image::AnyImage& picture) {
  return std::visit([](const auto& p) { return p.channels == 4; }, picture);
}

bool isDeep(const image::AnyImage& picture) { return std::holds_alternative<image::DeepImage>(picture); }

std::string sizeMismatch(const DiffPicture& reference, const DiffPicture& test) {
  const image::PixelSize a = sizeOf(reference.pixels), b = sizeOf(test.pixels);
  return a == b ? "" : fmt::format("the size is {}x{}, not {}x{}", b.width, b.height, a.width, a.height);
}

std::string storageText(const image::PngStorage& stored) {
  constexpr const char* kKinds[] = {"", "grey", "grey and alpha", "RGB", "RGB and alpha"};
  const std::string kind = !stored.palette        ? kKinds[stored.channels]
                           : stored.channels == 4 ? "palette and alpha"
                                                  : "palette";
  return kind + (stored.deep ? " of 16 bits" : "");
}

/// Returns remarks on different storage formats and colour spaces, which are not differences of pixels.
std::vector<std::string> notesOf(const ComparedPictures& compared) {
  std::vector<std::string> notes;
  const auto& [reference, test, diff, flip] = compared;
  if (!diff.storedAlike)
    notes.push_back(fmt::format("stored as {} instead of {}{}", storageText(test.stored),
                                storageText(reference.stored),
                                diff.verdict == Verdict::kIdentical ? ", same pixels" : ""));
  if (!(test.color == reference.color))
    notes.push_back(
        fmt::format("{} instead of {}; both are compared as sRGB", test.color.name, reference.color.name));
  return notes;
}

/// Returns text such as "3 of 90 frames are different, the first is frame 40 at 1.333 s; the worst, frame 45 at
/// 1.500 s".
std::string frameText(const PictureDiff& diff) {
  const FilmSummary& film = *diff.film;
  const std::string worst = fmt::format("frame {} at {:.3f} s", film.worst, film.worst_s);
  if (film.differing == 1) return worst;
  return fmt::format("{} of {} frames are {}, the first is frame {} at {:.3f} s; the worst, {}", film.differing,
                     film.frames, toString(diff.verdict), film.first, film.first_s, worst);
}

void compareForms(ComparedPictures& compared, const DiffRequest& request) {
  PictureDiff& diff = compared.diff;
  const auto ignored = ignoreMaskOf(request.rule, diff.size);
  const ComparisonOptions options{request.pixelsPerDegree, request.rule.limits.level,
                                  ignored ? &*ignored : nullptr};
  Comparison made = compareCommon(compared.reference.pixels, compared.test.pixels, options);
  compared.flip = std::move(made.flip);
  diff.hasFigures = true;
  diff.figures = std::move(made.difference);
  expectCanRefuse(request.rule.limits, "the limits", diff.figures.comparedPixels);
  constexpr std::size_t kMostBoxes = 400;
  diff.ignoredShare = ignored ? ignored->share() : 0;
  if (ignored) diff.ignored = ignored->boxes(kMostBoxes);
  diff.verdict = verdict(diff.figures, request.rule.limits);
  diff.beyond = distanceBeyond(diff.figures, request.rule.limits);
  if (diff.verdict == Verdict::kDifferent) diff.excesses = excesses(diff.figures, request.rule.limits);
  if (diff.verdict == Verdict::kIdentical) return;
  const auto& [reference, test, same, flip] = compared;
  diff.changes = changesBetween(reference.pixels,
                                ignored ? withIgnoredOf(reference.pixels, test.pixels, *ignored) : test.pixels,
                                ignored ? &*ignored : nullptr);
}

}  // namespace

std::string reasonOf(const PictureDiff& diff) {
  std::vector<std::string> parts;
  if (!diff.mismatch.empty()) parts.push_back(diff.mismatch);
  const std::string beyond = core::joined(diff.excesses, ", ");
  if (!beyond.empty()) parts.push_back(diff.film ? fmt::format("{}: {}", frameText(diff), beyond) : beyond);
  return core::joined(parts, "; ");
}

ComparedPictures comparePictures(DiffPicture reference, DiffPicture test, const DiffRequest& request) {
  ComparedPictures compared{std::move(reference), std::move(test), {}, {}};
  PictureDiff& diff = compared.diff;
  diff.size = sizeOf(compared.reference.pixels);
  diff.channels = compared.reference.stored.channels;
  diff.storedAlike = compared.reference.stored == compared.test.stored;
  diff.mismatch = sizeMismatch(compared.reference, compared.test);
  if (!diff.mismatch.empty()) return compared;
  const image::AnyImage &a = compared.reference.pixels, &b = compared.test.pixels;
  const PixelKind kind{hasAlpha(a) || hasAlpha(b), isDeep(a) || isDeep(b)};
  request::expectWithinMemory(compareMemory_bytes(diff.size, kind),
                              fmt::format("comparing pictures of {}x{}", diff.size.width, diff.size.height),
                              request.limits);
  toCommonForm(compared.reference.pixels, compared.test.pixels);
  compareForms(compared, request);
  diff.notes = notesOf(compared);
  return compared;
}

const output::FileKind& mapKind() {
  static const output::FileKind kind{
      "a map", [](const std::filesystem::path& file) { return image::isOwnPng(file, kMapKey); }};
  return kind;
}

void addRemovalOfMaps(core::FileBatch& batch, const DiffRequest& request) {
  for (const auto& place : {request.map, request.difference})
    if (place && mapKind().isOwn(*place)) batch.remove(*place);
}

void forgetMaps(const DiffRequest& request) {
  core::FileBatch batch;
  addRemovalOfMaps(batch, request);
  batch.commit();
}

image::Image differenceOf(const ComparedPictures& compared, const DiffRequest& request) {
  const auto ignored = ignoreMaskOf(request.rule, compared.diff.size);
  return amplifiedDifference(compared.reference.pixels, compared.test.pixels, ignored ? &*ignored : nullptr);
}

void addMaps(core::FileBatch& batch, const ComparedPictures& compared, const DiffRequest& request) {
  if (!compared.diff.hasFigures) return addRemovalOfMaps(batch, request);
  const auto add = [&](const std::filesystem::path& place, const image::Image& map, const char* shown) {
    batch.write(place, image::encodePng(map, {{kMapKey, shown}}));
  };
  if (request.map) add(*request.map, magmaPicture(compared.flip), "FLIP");
  if (request.difference) add(*request.difference, differenceOf(compared, request), "difference");
}

void writeMaps(const ComparedPictures& compared, const DiffRequest& request) {
  core::FileBatch batch;
  addMaps(batch, compared, request);
  batch.commit();
}

}  // namespace poinsot::compare
