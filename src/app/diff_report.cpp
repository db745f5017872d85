// SPDX-License-Identifier: Apache-2.0
#include "app/diff_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/diff_curve.h"
#include "app/diff_page.h"
#include "app/diff_text.h"
#include "app/file_diff.h"
#include "app/parallel.h"
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

DiffPage pageOf(const DiffSubject& subject, image::Verdict verdict, const std::string& entry) {
  DiffPage page{subject.test.native(), std::string(image::toString(verdict))};
  page.note = "compared with " + subject.reference.native();
  page.entry = entry;
  return page;
}

/// What every pair has, without pictures.
DiffPageEntry entryOf(const PictureDiff& diff, const std::string& name, const DiffSubject& subject) {
  DiffPageEntry entry{name, std::string(image::toString(diff.verdict)), reasonOf(diff), diff};
  entry.hasFigures = diff.hasFigures;
  entry.pixelsPerDegree = subject.request.pixelsPerDegree;
  return entry;
}

void addMaps(DiffPageEntry& entry, const ComparedPictures& compared, const DiffSubject& subject) {
  if (!compared.diff.hasFigures) return;
  entry.map = textOf(image::encodePng(image::magmaPicture(compared.flip)));
  entry.difference = textOf(image::encodePng(differenceOf(compared, subject.request)));
}

/// Both files, and what is drawn of them; nothing of those that cannot be read, which is said of them already.
void addPictures(DiffPageEntry& entry, const DiffSubject& subject) try {
  const fs::path reference = subject.reference / entry.diff.name, test = subject.test / entry.diff.name;
  entry.reference = pngFile(reference);
  entry.actual = pngFile(test);
  addMaps(entry, compareFiles(reference, test, subject.request), subject);
} catch (const core::Error&) {
  entry.reference = entry.actual = {};
}

/// Places of the pairs that are not identical, the worst first.
std::vector<std::size_t> worstPairs(const std::vector<PictureDiff>& pairs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].verdict != image::Verdict::kIdentical) order.push_back(i);
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return badness(pairs[a]) > badness(pairs[b]); });
  return order;
}

/// Pictures of the pairs in that order, `jobs` at a time, while there is room. @returns of how many.
std::size_t addPictures(DiffPage& page, const std::vector<std::size_t>& order, const DiffSubject& subject,
                        int jobs) {
  std::size_t done = 0;
  while (done < std::min(order.size(), kMostPairs) && page.hasRoom()) {
    const std::size_t count = std::min({static_cast<std::size_t>(jobs), order.size() - done, kMostPairs - done});
    forEachIndex(count, jobs, [&](std::size_t i) { addPictures(page.entries[order[done + i]], subject); });
    done += count;
  }
  return done;
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
  const std::size_t parts = std::min(kFilmParts, frames.size());
  for (std::size_t part = 0; part < parts; ++part) {
    const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(part * frames.size() / parts);
    const auto end = frames.begin() + static_cast<std::ptrdiff_t>((part + 1) * frames.size() / parts);
    const auto place = std::ranges::max_element(begin, end, {}, badness);
    if (place->verdict != image::Verdict::kIdentical)
      worst.push_back(static_cast<std::size_t>(place - frames.begin()));
  }
  return worst;
}

DiffPageEntry frameEntry(const FilmDiff& diff, std::size_t frame, const ComparedPictures& compared,
                         const DiffSubject& subject) {
  DiffPageEntry entry = entryOf(diff.frames[frame], fmt::format("{}", frame), subject);
  if (diff.fps.num != 0) entry.facts = {{"time", fmt::format("{:.3f} s", diff.time_s(frame))}};
  entry.reference = pngOf(compared.reference.pixels);
  entry.actual = pngOf(compared.test.pixels);
  addMaps(entry, compared, subject);
  return entry;
}

}  // namespace

std::string diffReport(const ComparedPictures& compared, const DiffSubject& subject) {
  DiffPage page = pageOf(subject, compared.diff.verdict, "Picture");
  DiffPageEntry& entry = page.entries.emplace_back(entryOf(compared.diff, subject.test.filename(), subject));
  entry.reference = pngOf(compared.reference.pixels);
  if (compared.diff.verdict == image::Verdict::kIdentical) return htmlOf(page);
  entry.actual = pngOf(compared.test.pixels);
  addMaps(entry, compared, subject);
  return htmlOf(page);
}

std::string diffReport(const FolderDiff& diff, const DiffSubject& subject, int jobs) {
  DiffPage page = pageOf(subject, diff.verdict(), "Picture");
  for (const PictureDiff& pair : diff.pictures) page.entries.push_back(entryOf(pair, pair.name, subject));
  const auto order = worstPairs(diff.pictures);
  for (std::size_t i = addPictures(page, order, subject, jobs); i < order.size(); ++i)
    page.entries[order[i]].facts.emplace_back("pictures", "left out: those of worse ones fill the page");
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
  page.curve = DiffPageCurve{curveSvg(diff, subject.request.rule.limits), kCurveLeft, kCurveRight, {}};
  const double last = std::max<double>(1, static_cast<double>(diff.frames.size()) - 1);
  forFrames(subject.reference, subject.test, worstFrames(diff.frames), subject.request,
            [&](std::size_t frame, const ComparedPictures& compared) {
              if (!page.hasRoom()) return;
              page.entries.push_back(frameEntry(diff, frame, compared, subject));
              page.curve->placesOfEntries.push_back(static_cast<double>(frame) / last);
            });
  return htmlOf(page);
}

}  // namespace poinsot::app
