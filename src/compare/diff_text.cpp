// SPDX-License-Identifier: Apache-2.0
#include "compare/diff_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "core/text.h"

namespace poinsot::compare {
namespace {

std::string verdictLine(Verdict verdict, const std::string& reason) {
  return fmt::format("{}{}{}\n", toString(verdict), reason.empty() ? "" : ": ", reason);
}

std::string sampleText(const std::array<int, 4>& samples, int channels) {
  return fmt::format("{}", fmt::join(samples.begin(), samples.begin() + channels, " "));
}

std::string worstText(const PictureDiff& diff) {
  std::string text;
  for (const DifferingPixel& pixel : diff.figures.worst)
    text += fmt::format("  {:<18} ({}, {}): {} became {}\n", text.empty() ? "worst pixels" : "", pixel.x, pixel.y,
                        sampleText(pixel.a, diff.figures.channels), sampleText(pixel.b, diff.figures.channels));
  return text;
}

std::string figuresText(const PictureDiff& diff, double pixelsPerDegree) {
  std::string text = fmt::format("  {:<18} {}\n", "what changed", wordsOf(diff.changes));
  for (const auto& [term, figures] : termsOf(diff, pixelsPerDegree))
    text += fmt::format("  {:<18} {}\n", term, figures);
  return text + worstText(diff);
}

std::string notesText(const PictureDiff& diff) {
  std::string text;
  if (diff.ignoredShare > 0)
    text += fmt::format("  {:<18} {:.3g} % of the picture\n", "ignored", 100 * diff.ignoredShare);
  for (const std::string& note : diff.notes) text += fmt::format("  {:<18} {}\n", "note", note);
  return text;
}

/// Returns one line for each note, such as a different storage format, with the number of pictures that have the
/// note.
std::string notesText(const std::vector<Outcome>& outcomes) {
  constexpr std::size_t kMostNames = 3;
  std::map<std::string, std::vector<std::string>> names;
  for (const Outcome& outcome : outcomes)
    for (const std::string& note : outcome.diff.notes) names[note].push_back(core::printable(outcome.name));
  std::string text;
  for (const auto& [note, all] : names)
    text += fmt::format("  note: {} of {}: {}{}\n", all.size(), outcomes.size(), note,
                        all.size() > kMostNames ? "" : fmt::format(" ({})", fmt::join(all, ", ")));
  return text;
}

std::string beyondText(const PictureDiff& diff) {
  return diff.excesses.empty() ? "" : fmt::format("  beyond     {}\n", reasonOf(diff));
}

std::string rowText(const PictureDiff& diff, const char* kind = "") {
  const ImageDifference& d = diff.figures;
  if (!diff.hasFigures)
    return fmt::format("  {:<9}  {}: {}\n", diff.isReadable ? "different" : "error", core::printable(diff.name),
                       diff.mismatch);
  if (diff.film)
    return fmt::format("  {:<9}  {}{}: {}\n", toString(diff.verdict), kind, core::printable(diff.name),
                       reasonOf(diff));
  const std::string change = wordsOf(diff.changes);
  return fmt::format("  {:<9}  {}{}: largest {:.4g}, {} pixels, FLIP mean {:.3g}, max {:.3g}{}{}\n",
                     toString(diff.verdict), kind, core::printable(diff.name), d.maxAbs, d.differingPixels,
                     d.flip.mean, d.flip.max, change.empty() ? "" : "; ", change);
}

std::string rowText(const Outcome& outcome) {
  if (outcome.status == OutcomeStatus::kMissing || outcome.status == OutcomeStatus::kNew)
    return fmt::format("  {:<9}  {}\n", toString(outcome.status), core::printable(outcome.name));
  return rowText(outcome.diff);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> termsOf(const PictureDiff& diff, double pixelsPerDegree) {
  const ImageDifference& d = diff.figures;
  const std::string beyondLevel =
      d.level > 0 ? fmt::format(", {} by more than {:g}", d.countedPixels, d.level) : "";
  std::vector<std::pair<std::string, std::string>> terms{
      {"differing pixels", fmt::format("{} of {} ({:.3g} %){}", d.differingPixels, d.comparedPixels,
                                       100 * d.differingShare, beyondLevel)},
      {"difference", fmt::format("largest {:.4g}, mean {:.3g}, RMSE {:.3g} (of 255){}", d.maxAbs, d.meanAbs,
                                 d.rmse, d.psnr_dB ? fmt::format(", PSNR {:.2f} dB", *d.psnr_dB) : "")}};
  if (d.ssim)
    terms.emplace_back("SSIM", fmt::format("mean {:.6f}, worst window {:.4f} at ({}, {})", d.ssim->mean,
                                           d.ssim->worst, d.ssim->worstX, d.ssim->worstY));
  const FlipFigures& f = d.flip;
  terms.emplace_back("FLIP",
                     fmt::format("mean {:.3g}, max {:.3g}; weighted median {:.3g}, quartiles {:.3g} and "
                                 "{:.3g} ({:.4g} pixels per degree)",
                                 f.mean, f.max, f.median, f.firstQuartile, f.thirdQuartile, pixelsPerDegree));
  return terms;
}

std::string countsText(const std::vector<PictureDiff>& pictures) {
  std::string text;
  for (const auto verdict : {Verdict::kIdentical, Verdict::kNear, Verdict::kDifferent}) {
    const auto count = std::ranges::count(pictures, verdict, &PictureDiff::verdict);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, toString(verdict));
  }
  return text;
}

std::string diffText(const PictureDiff& diff, const DiffRequest& request) {
  const std::string head = verdictLine(diff.verdict, reasonOf(diff));
  const bool figures = diff.hasFigures && diff.verdict != Verdict::kIdentical;
  return head + (figures ? figuresText(diff, request.pixelsPerDegree) : "") + notesText(diff);
}

std::string diffText(const std::vector<Outcome>& outcomes, const std::vector<std::string>& links) {
  std::string text = verdictLine(verdictOf(outcomes), countsText(outcomes));
  for (const Outcome& outcome : outcomes)
    if (outcome.status != OutcomeStatus::kIdentical) text += rowText(outcome);
  for (const std::string& link : links)
    text += fmt::format("  note: {}: is a link to a folder, which is not followed\n", core::printable(link));
  return text + notesText(outcomes);
}

std::string diffText(const FilmDiff& diff) {
  std::string text = verdictLine(diff.verdict(), diff.mismatch);
  if (diff.frames.empty()) return text;
  text += fmt::format("  frames     {}\n", countsText(diff.frames));
  const std::size_t worst = diff.worst(), first = diff.first();
  const auto verdict = diff.frames[worst].verdict;
  if (verdict == Verdict::kIdentical) return text;
  text += fmt::format("  first      frame {}, at {:.3f} s, is {}\n", first, diff.time_s(first), toString(verdict));
  return text + fmt::format("  the worst, at {:.3f} s:\n", diff.time_s(worst)) +
         rowText(diff.frames[worst], "frame ") + beyondText(diff.frames[worst]);
}

}  // namespace poinsot::compare
