// SPDX-License-Identifier: Apache-2.0
#include "app/diff_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/text.h"

namespace poinsot::app {
namespace {

/// Why a pair has its verdict.
std::string reasonOf(const PictureDiff& diff) {
  if (!diff.mismatch.empty()) return diff.mismatch;
  return fmt::format("{}", fmt::join(diff.excesses, ", "));
}

std::string verdictLine(image::Verdict verdict, const std::string& reason) {
  return fmt::format("{}{}{}\n", image::toString(verdict), reason.empty() ? "" : ": ", reason);
}

std::string sampleText(const std::array<int, 4>& samples, int channels) {
  // Grey is compared as RGB of three equal values.
  const int count = channels % 2 == 0 ? 4 : 3;
  return fmt::format("{}", fmt::join(samples.begin(), samples.begin() + count, " "));
}

std::string worstText(const PictureDiff& diff) {
  std::string text;
  for (const image::DifferingPixel& pixel : diff.figures.worst)
    text += fmt::format("  {:<18} ({}, {}): {} became {}\n", text.empty() ? "worst pixels" : "", pixel.x, pixel.y,
                        sampleText(pixel.a, diff.channels), sampleText(pixel.b, diff.channels));
  return text;
}

std::string figuresText(const PictureDiff& diff, double pixelsPerDegree) {
  const image::ImageDifference& d = diff.figures;
  const double pixels = static_cast<double>(diff.size.width) * diff.size.height;
  std::string text =
      fmt::format("  {:<18} {} of {:.0f} ({:.3g} %)\n", "differing pixels", d.differingPixels, pixels,
                  100 * d.differingShare) +
      fmt::format("  {:<18} largest {:.4g}, mean {:.3g}, RMSE {:.3g} (of 255){}\n", "difference", d.maxAbs,
                  d.meanAbs, d.rmse, d.psnr_dB ? fmt::format(", PSNR {:.2f} dB", *d.psnr_dB) : "");
  if (d.ssim)
    text += fmt::format("  {:<18} mean {:.6f}, worst window {:.4f} at ({}, {})\n", "SSIM", d.ssim->mean,
                        d.ssim->worst, d.ssim->worstX, d.ssim->worstY);
  const image::FlipFigures& f = d.flip;
  text += fmt::format(
      "  {:<18} mean {:.3g}, max {:.3g}; weighted median {:.3g}, quartiles {:.3g} and {:.3g} ({:.4g} "
      "pixels per degree)\n",
      "FLIP", f.mean, f.max, f.median, f.firstQuartile, f.thirdQuartile, pixelsPerDegree);
  return text + worstText(diff);
}

/// One line of a pair among many.
std::string rowText(const PictureDiff& diff) {
  const image::ImageDifference& d = diff.figures;
  if (!diff.mismatch.empty())
    return fmt::format("  different  {}: {}\n", core::printable(diff.name), diff.mismatch);
  return fmt::format("  {:<9}  {}: largest {:.4g}, {} pixels, FLIP mean {:.3g}, max {:.3g}\n",
                     image::toString(diff.verdict), core::printable(diff.name), d.maxAbs, d.differingPixels,
                     d.flip.mean, d.flip.max);
}

}  // namespace

std::string countsText(const std::vector<PictureDiff>& pictures) {
  std::string text;
  for (const auto verdict : {image::Verdict::kIdentical, image::Verdict::kNear, image::Verdict::kDifferent}) {
    const auto count = std::ranges::count(pictures, verdict, &PictureDiff::verdict);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, image::toString(verdict));
  }
  return text;
}

std::string diffText(const PictureDiff& diff, const DiffRequest& request) {
  const std::string head = verdictLine(diff.verdict, reasonOf(diff));
  const bool figures = diff.mismatch.empty() && diff.verdict != image::Verdict::kIdentical;
  return figures ? head + figuresText(diff, request.pixelsPerDegree) : head;
}

std::string diffText(const FolderDiff& diff) {
  std::string text = verdictLine(diff.verdict(), countsText(diff.pictures));
  for (const PictureDiff& picture : diff.pictures)
    if (picture.verdict != image::Verdict::kIdentical) text += rowText(picture);
  for (const std::string& name : diff.onlyInReference)
    text += fmt::format("  missing    {}\n", core::printable(name));
  for (const std::string& name : diff.onlyInTest) text += fmt::format("  new        {}\n", core::printable(name));
  return text;
}

std::string diffText(const FilmDiff& diff) {
  std::string text = verdictLine(diff.verdict(), diff.mismatch);
  if (diff.frames.empty()) return text;
  text += fmt::format("  frames     {}\n", countsText(diff.frames));
  const std::size_t worst = diff.worst();
  if (diff.frames[worst].verdict == image::Verdict::kIdentical) return text;
  return text + fmt::format("  the worst, at {:.3f} s:\n", diff.time_s(worst)) + rowText(diff.frames[worst]);
}

}  // namespace poinsot::app
