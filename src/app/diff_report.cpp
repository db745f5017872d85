// SPDX-License-Identifier: Apache-2.0
#include "app/diff_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/diff_curve.h"
#include "app/diff_page.h"
#include "app/diff_text.h"
#include "core/regular_file.h"
#include "image/magma.h"
#include "image/png_file.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPairs = 100, kFilmParts = 20;

std::string textOf(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

DiffPageEntry::Png pngOf(const image::AnyImage& picture) {
  return textOf(std::visit([](const auto& p) { return image::encodePng(p); }, picture));
}

DiffPageEntry::Png fileOf(const fs::path& png) {
  constexpr std::size_t kMost = std::size_t{512} << 20;
  return core::readRegularFile(png, kMost, core::ErrorKind::kIo);
}

DiffPage pageOf(const DiffSubject& subject, image::Verdict verdict, const std::string& entry) {
  DiffPage page{subject.test.native(), std::string(image::toString(verdict))};
  page.note = "compared with " + subject.reference.native();
  page.entry = entry;
  return page;
}

/// What every pair has, without pictures.
DiffPageEntry entryOf(const PictureDiff& diff, const std::string& name) {
  DiffPageEntry entry{name, std::string(image::toString(diff.verdict)), diff.mismatch, diff};
  if (diff.mismatch.empty()) entry.message = fmt::format("{}", fmt::join(diff.excesses, ", "));
  entry.hasFigures = diff.mismatch.empty();
  return entry;
}

void addMaps(DiffPageEntry& entry, const ComparedPictures& compared) {
  if (!compared.diff.mismatch.empty()) return;
  entry.map = textOf(image::encodePng(image::magmaPicture(compared.flip)));
  entry.difference =
      textOf(image::encodePng(image::amplifiedDifference(compared.reference.pixels, compared.test.pixels)));
}

/// Both files, and what is drawn of them where they are not identical.
void addPictures(DiffPageEntry& entry, const fs::path& reference, const fs::path& test,
                 const DiffRequest& request) {
  entry.reference = fileOf(reference);
  if (entry.diff.verdict == image::Verdict::kIdentical) return;
  entry.actual = fileOf(test);
  addMaps(entry, compareFiles(reference, test, request));
}

/// Places of the pairs whose pictures are shown.
std::set<std::size_t> shownOf(const std::vector<PictureDiff>& pairs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].verdict != image::Verdict::kIdentical) order.push_back(i);
  const auto rank = [&](std::size_t i) { return std::tuple(pairs[i].verdict, pairs[i].figures.flip.mean); };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return rank(a) > rank(b); });
  order.resize(std::min(order.size(), kMostPairs));
  return {order.begin(), order.end()};
}

DiffPageEntry loneEntry(const std::string& name, const char* status, const char* message) {
  DiffPageEntry entry;
  entry.name = name;
  entry.status = status;
  entry.message = message;
  return entry;
}

/// The worst of each part of the film that are not identical, rising.
std::vector<std::size_t> worstFrames(const std::vector<PictureDiff>& frames) {
  std::vector<std::size_t> worst;
  const auto rank = [](const PictureDiff& frame) { return std::tuple(frame.verdict, frame.figures.flip.mean); };
  const std::size_t parts = std::min(kFilmParts, frames.size());
  for (std::size_t part = 0; part < parts; ++part) {
    const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(part * frames.size() / parts);
    const auto end = frames.begin() + static_cast<std::ptrdiff_t>((part + 1) * frames.size() / parts);
    const auto place = std::ranges::max_element(begin, end, {}, rank);
    if (place->verdict != image::Verdict::kIdentical)
      worst.push_back(static_cast<std::size_t>(place - frames.begin()));
  }
  return worst;
}

DiffPageEntry frameEntry(const FilmDiff& diff, std::size_t frame, const ComparedPictures& compared) {
  DiffPageEntry entry = entryOf(diff.frames[frame], fmt::format("{}", frame));
  entry.facts = {{"time", fmt::format("{:.3f} s", diff.time_s(frame))}};
  entry.reference = pngOf(compared.reference.pixels);
  entry.actual = pngOf(compared.test.pixels);
  addMaps(entry, compared);
  return entry;
}

}  // namespace

std::string diffReport(const PictureDiff& diff, const DiffSubject& subject) {
  DiffPage page = pageOf(subject, diff.verdict, "Picture");
  page.entries.push_back(entryOf(diff, subject.test.filename()));
  addPictures(page.entries.front(), subject.reference, subject.test, subject.request);
  return htmlOf(page);
}

std::string diffReport(const FolderDiff& diff, const DiffSubject& subject) {
  DiffPage page = pageOf(subject, diff.verdict(), "Picture");
  const auto shown = shownOf(diff.pictures);
  for (std::size_t i = 0; i < diff.pictures.size(); ++i) {
    const PictureDiff& pair = diff.pictures[i];
    DiffPageEntry& entry = page.entries.emplace_back(entryOf(pair, pair.name));
    if (shown.contains(i))
      addPictures(entry, subject.reference / pair.name, subject.test / pair.name, subject.request);
    else if (pair.verdict != image::Verdict::kIdentical)
      entry.facts = {{"pictures", fmt::format("only those of the {} worst are in this page", kMostPairs)}};
  }
  for (const std::string& name : diff.onlyInReference)
    page.entries.push_back(loneEntry(name, "missing", "only in the reference"));
  for (const std::string& name : diff.onlyInTest)
    page.entries.push_back(loneEntry(name, "new", "nothing in the reference has this name"));
  return htmlOf(page);
}

std::string diffReport(const FilmDiff& diff, const DiffSubject& subject) {
  DiffPage page = pageOf(subject, diff.verdict(), "Frame");
  if (!diff.mismatch.empty()) page.note += "; " + diff.mismatch;
  if (diff.frames.empty()) return htmlOf(page);
  page.counts = fmt::format("{} frames: {}", diff.frames.size(), countsText(diff.frames));
  page.curve = DiffPageCurve{curveSvg(diff, subject.request.rule), kCurveLeft, kCurveRight, {}};
  const double last = std::max<double>(1, static_cast<double>(diff.frames.size()) - 1);
  forFrames(subject.reference, subject.test, worstFrames(diff.frames), subject.request,
            [&](std::size_t frame, const ComparedPictures& compared) {
              page.entries.push_back(frameEntry(diff, frame, compared));
              page.curve->placesOfEntries.push_back(static_cast<double>(frame) / last);
            });
  return htmlOf(page);
}

}  // namespace poinsot::app
