// SPDX-License-Identifier: Apache-2.0
#include "app/golden_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/regular_file.h"

// Of golden_page.html.
extern "C" const char poinsot_golden_page[], poinsot_golden_page_end[];

namespace poinsot::app {
namespace {

using nlohmann::ordered_json;

ordered_json pictureJson(const std::filesystem::path& file) {
  if (file.empty()) return nullptr;
  constexpr std::size_t kMost = std::size_t{512} << 20;
  return "data:image/png;base64," + core::base64(core::readRegularFile(file, kMost, core::ErrorKind::kIo));
}

/// Terms and what is to be said of them.
ordered_json factsJson(const GoldenOutcome& outcome) {
  ordered_json facts = ordered_json::array();
  const auto add = [&](const char* term, const std::string& text) {
    if (!text.empty()) facts.push_back({term, text});
  };
  const image::ImageDifference& d = outcome.diff.figures;
  if (d.differingPixels > 0) {
    add("differing pixels", fmt::format("{} ({:.3g} %)", d.differingPixels, 100 * d.differingShare));
    add("difference", fmt::format("largest {:.4g}, mean {:.3g}, RMSE {:.3g}", d.maxAbs, d.meanAbs, d.rmse));
    if (d.psnr_dB) add("PSNR", fmt::format("{:.2f} dB", *d.psnr_dB));
    if (d.ssim)
      add("SSIM", fmt::format("mean {:.6f}, worst window {:.4f} at ({}, {})", d.ssim->mean, d.ssim->worst,
                              d.ssim->worstX, d.ssim->worstY));
    add("FLIP", fmt::format("mean {:.3g}, max {:.3g}", d.flip.mean, d.flip.max));
    add("worst pixel", fmt::format("({}, {})", d.worst.front().x, d.worst.front().y));
  }
  add("approved", outcome.reference.native());
  add("new", outcome.actual.native());
  add("renderer", outcome.origin.renderer);
  return facts;
}

ordered_json testJson(const GoldenOutcome& outcome) {
  ordered_json json{{"name", outcome.name}, {"status", toString(outcome.status)}, {"message", outcome.message}};
  const image::ImageDifference& d = outcome.diff.figures;
  const bool compared = !outcome.reference.empty() && outcome.diff.mismatch.empty() &&
                        outcome.status != GoldenStatus::kUnused && outcome.status != GoldenStatus::kError;
  if (compared)
    json.update({{"max_difference", d.maxAbs},
                 {"differing_pixels", d.differingPixels},
                 {"flip_mean", d.flip.mean},
                 {"flip_max", d.flip.max}});
  json["width"] = outcome.diff.size.width;
  json["facts"] = factsJson(outcome);
  json["reference"] = pictureJson(outcome.reference);
  if (outcome.status == GoldenStatus::kIdentical) return json;
  json["actual"] = pictureJson(outcome.actual);
  json["difference"] = pictureJson(outcome.difference);
  json["flip"] = pictureJson(outcome.map);
  return json;
}

/// Inside a script element nothing may end it.
std::string scriptText(const ordered_json& json) {
  const std::string text = json.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
  std::string safe;
  for (const char c : text) c == '<' ? safe += "\\u003c" : safe += c;
  return safe;
}

}  // namespace

std::string goldenPage(const std::string& suite, const std::vector<GoldenOutcome>& outcomes, bool exact) {
  const bool passed = std::ranges::all_of(outcomes, [&](const GoldenOutcome& o) { return o.passes(exact); });
  ordered_json data{{"suite", suite}, {"verdict", passed ? "passed" : "failed"}, {"tests", ordered_json::array()}};
  for (const GoldenOutcome& outcome : outcomes) data["tests"].push_back(testJson(outcome));
  std::string page(poinsot_golden_page, poinsot_golden_page_end);
  constexpr std::string_view kMark = "@DATA@";
  return page.replace(page.find(kMark), kMark.size(), scriptText(data));
}

}  // namespace poinsot::app
