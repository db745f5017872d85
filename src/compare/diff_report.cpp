// SPDX-License-Identifier: Apache-2.0
#include "compare/diff_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "compare/diff_curve.h"
#include "compare/diff_text.h"

namespace poinsot::compare {
namespace {

constexpr std::size_t kFilmParts = 20;

/// Returns the number of the worst frame in each twentieth of the film, in rising order. Identical frames are left
/// out.
std::vector<std::size_t> worstFrames(const std::vector<PictureDiff>& frames) {
  std::vector<std::size_t> worst;
  const std::size_t parts = std::min(kFilmParts, frames.size());
  for (std::size_t part = 0; part < parts; ++part) {
    const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(part * frames.size() / parts);
    const auto end = frames.begin() + static_cast<std::ptrdiff_t>((part + 1) * frames.size() / parts);
    const auto place = std::ranges::max_element(begin, end, {}, badness);
    if (place->verdict != Verdict::kIdentical) worst.push_back(static_cast<std::size_t>(place - frames.begin()));
  }
  return worst;
}

DiffPageEntry frameEntry(const FilmDiff& diff, std::size_t frame, const ComparedPictures& compared,
                         const OutcomePageHead& head) {
  Outcome outcome;
  outcome.name = fmt::format("{}", frame);
  outcome.status = statusOf(compared.diff.verdict);
  outcome.message = reasonOf(compared.diff);
  outcome.diff = compared.diff;
  DiffPageEntry entry = entryOf(outcome, head);
  entry.facts.emplace_back("time", fmt::format("{:.3f} s", diff.time_s(frame)));
  embedCompared(entry, compared);
  return entry;
}

/// Reports whether the comparison contains the two pictures. It does not if a file was unreadable, or if a film
/// was compared with a picture.
bool hasPictures(const ComparedPictures& compared) {
  return std::visit([](const auto& picture) { return picture.size.width > 0; }, compared.reference.pixels);
}

}  // namespace

std::string diffReport(const ComparedPictures& compared, const Outcome& outcome, const OutcomePageHead& head) {
  DiffPage page = pageOf(head);
  DiffPageEntry& entry = page.entries.emplace_back(entryOf(outcome, head));
  if (compared.diff.verdict == Verdict::kIdentical) return htmlOf(page);
  if (hasPictures(compared))
    embedCompared(entry, compared);
  else
    embedFiles(entry);
  EmbedBudget().admit(entry);
  return htmlOf(page);
}

std::string diffReport(const FilmDiff& diff, const std::filesystem::path& reference,
                       const std::filesystem::path& test, const DiffRequest& request, OutcomePageHead head) {
  head.entry = "Frame";
  head.approve.clear();  // only the complete film can be approved, not a frame
  if (!diff.mismatch.empty()) head.note += "; " + diff.mismatch;
  DiffPage page = pageOf(head);
  if (diff.frames.empty()) return htmlOf(page);
  page.counts = fmt::format("{} frames: {}", diff.frames.size(), countsText(diff.frames));
  page.curve = DiffPageCurve{curveSvg(diff, request.rule.limits), kCurveLeft, kCurveRight, {}};
  page.first = fmt::format("{}", diff.worst());
  const double last = std::max<double>(1, static_cast<double>(diff.frames.size()) - 1);
  EmbedBudget budget;
  forFrames(reference, test, worstFrames(diff.frames), request,
            [&](std::size_t frame, const ComparedPictures& compared) {
              budget.admit(page.entries.emplace_back(frameEntry(diff, frame, compared, head)));
              page.curve->placesOfEntries.push_back(static_cast<double>(frame) / last);
            });
  return htmlOf(page);
}

}  // namespace poinsot::compare
