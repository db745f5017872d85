// SPDX-License-Identifier: Apache-2.0
#include "app/diff_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/diff_curve.h"
#include "app/diff_page.h"
#include "app/diff_text.h"
#include "app/file_diff.h"
#include "app/parallel.h"
#include "app/run_facts.h"
#include "core/shell_word.h"
#include "image/magma.h"
#include "image/png_file.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFilmParts = 20;

std::string textOf(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

std::string pngOf(const image::AnyImage& picture) {
  return textOf(std::visit([](const auto& p) { return image::encodePng(p); }, picture));
}

DiffPage pageOf(const DiffSubject& subject, image::Verdict verdict, const std::string& entry) {
  DiffPage page{subject.test.native(), std::string(image::toString(verdict))};
  page.note = "compared with " + subject.reference.native();
  page.entry = entry;
  page.file = subject.page;
  page.run = runFacts(subject.reference);
  return page;
}

std::string statusText(const PictureDiff& diff) {
  return diff.isReadable ? std::string(image::toString(diff.verdict)) : "error";
}

/// Returns what every pair has, without pictures.
DiffPageEntry entryOf(const PictureDiff& diff, const std::string& name, const DiffSubject& subject) {
  DiffPageEntry entry{name, statusText(diff), reasonOf(diff), diff};
  entry.hasFigures = diff.hasFigures;
  entry.pixelsPerDegree = subject.request.pixelsPerDegree;
  return entry;
}

void addMap(DiffPageEntry& entry, const ComparedPictures& compared) {
  if (compared.diff.hasFigures) entry.map.png = textOf(image::encodePng(image::magmaPicture(compared.flip)));
}

/// Names the files of a row, for a page that does not embed them. An identical pair has one.
void addFiles(DiffPageEntry& entry, const DiffSubject& subject) {
  if (entry.status != "new") entry.reference.file = subject.reference / entry.name;
  if (entry.status != "missing" && entry.status != "identical") entry.actual.file = subject.test / entry.name;
  if (subject.request.map && entry.hasFigures && entry.status != "identical")
    entry.map.file = *subject.request.map / entry.name;
}

/// Embeds what can be read of a pair, and FLIP's map of both.
void embedPair(DiffPageEntry& entry, const DiffSubject& subject) try {
  embedFiles(entry);
  if (entry.hasFigures)
    addMap(entry, compareFiles(subject.reference / entry.name, subject.test / entry.name, subject.request));
} catch (const core::Error&) {  // the files changed meanwhile
  entry.map = {};
}

DiffPageEntry loneEntry(const std::string& name, const char* status, const char* message) {
  DiffPageEntry entry{name, status, message, {}};
  return entry;
}

std::vector<DiffPageEntry> entriesOf(const FolderDiff& diff, const DiffSubject& subject) {
  std::vector<DiffPageEntry> entries;
  for (const PictureDiff& pair : diff.pictures) entries.push_back(entryOf(pair, pair.name, subject));
  for (const std::string& name : diff.onlyInReference)
    entries.push_back(loneEntry(name, "missing", "only in the reference"));
  for (const std::string& name : diff.onlyInTest)
    entries.push_back(loneEntry(name, "new", "nothing in the reference has this name"));
  return entries;
}

/// Embeds pictures while the budget lasts, `jobs` pairs at a time.
void embedPairs(std::vector<DiffPageEntry>& entries, const DiffSubject& subject, int jobs) {
  const auto order = worstFirst(entries);
  EmbedBudget budget;
  for (std::size_t done = 0; done < order.size() && !budget.isSpent();) {
    const std::size_t count = std::min(static_cast<std::size_t>(jobs), order.size() - done);
    forEachIndex(count, jobs, [&](std::size_t i) { embedPair(*order[done + i], subject); });
    for (std::size_t i = 0; i < count; ++i) budget.admit(*order[done + i]);
    done += count;
  }
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
  entry.reference.png = pngOf(compared.reference.pixels);
  entry.actual.png = pngOf(compared.test.pixels);
  addMap(entry, compared);
  return entry;
}

}  // namespace

std::string diffReport(const ComparedPictures& compared, const DiffSubject& subject) {
  DiffPage page = pageOf(subject, compared.diff.verdict, "Picture");
  DiffPageEntry& entry = page.entries.emplace_back(entryOf(compared.diff, subject.test.filename(), subject));
  entry.reference.file = subject.reference;
  if (compared.diff.verdict == image::Verdict::kIdentical) return htmlOf(page);
  entry.actual.file = subject.test;
  entry.reference.png = pngOf(compared.reference.pixels);
  entry.actual.png = pngOf(compared.test.pixels);
  addMap(entry, compared);
  EmbedBudget().admit(entry);
  return htmlOf(page);
}

std::string diffReport(const FolderDiff& diff, const DiffSubject& subject, int jobs) {
  DiffPage page = pageOf(subject, diff.verdict(), "Picture");
  page.approve = core::shellWords({"poinsot", "diff", subject.reference, subject.test, "--update"});
  page.entries = entriesOf(diff, subject);
  for (DiffPageEntry& entry : page.entries) {
    addFiles(entry, subject);
    if (entry.status != "identical" && entry.status != "missing" && entry.status != "error")
      entry.approve = core::shellWord(entry.name);
  }
  embedPairs(page.entries, subject, jobs);
  return htmlOf(page);
}

std::string diffReport(const FilmDiff& diff, const DiffSubject& subject) {
  DiffPage page = pageOf(subject, diff.verdict(), "Frame");
  if (!diff.mismatch.empty()) page.note += "; " + diff.mismatch;
  if (diff.frames.empty()) return htmlOf(page);
  page.counts = fmt::format("{} frames: {}", diff.frames.size(), countsText(diff.frames));
  page.curve = DiffPageCurve{curveSvg(diff, subject.request.rule.limits), kCurveLeft, kCurveRight, {}};
  const double last = std::max<double>(1, static_cast<double>(diff.frames.size()) - 1);
  EmbedBudget budget;
  forFrames(subject.reference, subject.test, worstFrames(diff.frames), subject.request,
            [&](std::size_t frame, const ComparedPictures& compared) {
              budget.admit(page.entries.emplace_back(frameEntry(diff, frame, compared, subject)));
              page.curve->placesOfEntries.push_back(static_cast<double>(frame) / last);
            });
  return htmlOf(page);
}

}  // namespace poinsot::app
