// SPDX-License-Identifier: Apache-2.0
#include "compare/diff_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/json.h"

namespace poinsot::compare {
namespace {

using nlohmann::ordered_json;

ordered_json pixelJson(const DifferingPixel& pixel, int channels) {
  const auto samples = [&](const std::array<int, 4>& all) {
    return std::vector<int>(all.begin(), all.begin() + channels);
  };
  return {{"x", pixel.x},
          {"y", pixel.y},
          {"difference", pixel.difference},
          {"reference", samples(pixel.a)},
          {"test", samples(pixel.b)}};
}

ordered_json nullFigures() {
  ordered_json json;
  for (const char* key : {"differing_pixels", "differing_share", "counted_pixels", "ignored_share",
                          "max_difference", "mean_difference", "rmse", "psnr_db", "ssim", "flip"})
    json[key] = nullptr;
  return json;
}

ordered_json ssimJson(const std::optional<SsimFigures>& ssim) {
  if (!ssim) return nullptr;
  return {{"mean", ssim->mean}, {"worst", ssim->worst}, {"worst_at", {ssim->worstX, ssim->worstY}}};
}

ordered_json textOrNull(const std::string& text) { return text.empty() ? ordered_json() : ordered_json(text); }

ordered_json optional(const std::optional<double>& value) { return value ? ordered_json(*value) : ordered_json(); }

ordered_json limitsJson(const NearRule& rule) {
  ordered_json json{{"max_difference", rule.maxAbs}};
  if (rule.differingPixels)
    json["differing_pixels"] = *rule.differingPixels;
  else
    json["differing_share"] = rule.differingShare;
  json["level"] = rule.level;
  json["flip_mean"] = rule.flipMean;
  json["flip_max"] = rule.flipMax;
  return json;
}

ordered_json limitsJson(const PictureRule& rule) {
  ordered_json json = limitsJson(rule.limits), boxes = ordered_json::array();
  for (const image::PixelRect& box : rule.ignore)
    boxes.push_back({box.left, box.top, box.right - box.left, box.bottom - box.top});
  json["ignore"] = boxes;
  json["mask"] = textOrNull(rule.mask.native());
  return json;
}

ordered_json limitsJson(const DiffRequest& request) {
  ordered_json json = limitsJson(request.rule);
  json["pixels_per_degree"] = request.pixelsPerDegree;
  return json;
}

ordered_json headJson(Verdict verdict, const DiffNames& names) {
  return {{"verdict", toString(verdict)}, {"reference", names.reference}, {"test", names.test}};
}

bool isKnown(image::PixelSize size) { return size.width > 0; }

ordered_json sizeJson(const PictureDiff& diff) {
  return isKnown(diff.size) ? ordered_json({diff.size.width, diff.size.height}) : ordered_json();
}

/// Returns the ten largest places. Each is a list: left, top, width, height, number of differing pixels.
ordered_json placesJson(const Changes& changes) {
  constexpr std::size_t kMost = 10;
  ordered_json json = ordered_json::array();
  for (const auto& [box, pixels] : changes.places) {
    if (json.size() == kMost) break;
    json.push_back({box.left, box.top, box.right - box.left, box.bottom - box.top, pixels});
  }
  return json;
}

ordered_json filmJson(const FilmSummary& film) {
  return {{"frames", film.frames},        {"differing_frames", film.differing}, {"first_frame", film.first},
          {"first_time_s", film.first_s}, {"worst_frame", film.worst},          {"worst_time_s", film.worst_s}};
}

/// Returns the JSON object of one pair, without the names of its files.
/// @param worstPixels  whether to add `places` and `worst_pixels`
ordered_json figuresJson(const PictureDiff& diff, bool worstPixels) {
  ordered_json json{{"verdict", diff.isReadable ? toString(diff.verdict) : "error"},
                    {"mismatch", textOrNull(diff.mismatch)},
                    {"beyond", diff.excesses},
                    {"notes", diff.notes},
                    {"size", sizeJson(diff)},
                    {"channels", isKnown(diff.size) ? ordered_json(diff.channels) : ordered_json()}};
  const ImageDifference& d = diff.figures;
  if (!diff.hasFigures) {
    json.update(nullFigures());
  } else {
    json.update({{"differing_pixels", d.differingPixels},
                 {"differing_share", d.differingShare},
                 {"counted_pixels", d.countedPixels},
                 {"ignored_share", diff.ignoredShare},
                 {"max_difference", d.maxAbs},
                 {"mean_difference", d.meanAbs},
                 {"rmse", d.rmse},
                 {"psnr_db", optional(d.psnr_dB)},
                 {"ssim", ssimJson(d.ssim)},
                 {"flip",
                  {{"mean", d.flip.mean},
                   {"min", d.flip.min},
                   {"first_quartile", d.flip.firstQuartile},
                   {"median", d.flip.median},
                   {"third_quartile", d.flip.thirdQuartile},
                   {"max", d.flip.max}}}});
  }
  if (diff.film) json["film"] = filmJson(*diff.film);
  json["change"] = textOrNull(wordsOf(diff.changes));
  if (!worstPixels) return json;
  json["places"] = placesJson(diff.changes);
  json["worst_pixels"] = ordered_json::array();
  for (const DifferingPixel& pixel : d.worst) json["worst_pixels"].push_back(pixelJson(pixel, d.channels));
  return json;
}

ordered_json originJson(const PictureOrigin& origin) {
  ordered_json json{{"software", textOrNull(origin.software)},
                    {"driver", textOrNull(origin.driver)},
                    {"renderer", textOrNull(origin.renderer)},
                    {"scene_sha256", textOrNull(origin.scene)}};
  const bool isKnown = std::ranges::any_of(json, [](const ordered_json& fact) { return !fact.is_null(); });
  return isKnown ? json : nullptr;
}

ordered_json outcomeJson(const Outcome& outcome) {
  ordered_json json{{"name", outcome.name}};
  json.update(figuresJson(outcome.diff, true));
  json["verdict"] = toString(outcome.status);
  json.update({{"message", textOrNull(outcome.message)},
               {"reference", textOrNull(outcome.reference.native())},
               {"test", textOrNull(outcome.actual.native())},
               {"map", textOrNull(outcome.map.native())},
               {"renderer", textOrNull(outcome.origin.renderer)},
               {"approved_by", originJson(outcome.approved)},
               {"drawn_by", originJson(outcome.origin)},
               {"limits", limitsJson(outcome.rule)}});
  return json;
}

ordered_json outcomesJson(const std::vector<Outcome>& outcomes, const DiffNames& names) {
  ordered_json json = headJson(verdictOf(outcomes), names);
  for (const OutcomeStatus status : outcomeStatuses())
    json["counts"][std::string(toString(status))] = std::ranges::count(outcomes, status, &Outcome::status);
  json.update({{"pictures", ordered_json::array()},
               {"only_in_reference", ordered_json::array()},
               {"only_in_test", ordered_json::array()}});
  for (const Outcome& outcome : outcomes)
    if (outcome.status == OutcomeStatus::kUnused || outcome.status == OutcomeStatus::kMissing)
      json["only_in_reference"].push_back(outcome.name);
    else if (outcome.status == OutcomeStatus::kNew)
      json["only_in_test"].push_back(outcome.name);
    else
      json["pictures"].push_back(outcomeJson(outcome));
  return json;
}

}  // namespace

std::string suiteJson(const std::vector<Outcome>& outcomes, const DiffNames& names) {
  return core::jsonText(outcomesJson(outcomes, names));
}

std::string diffJson(const PictureDiff& diff, const DiffNames& names, const DiffRequest& request) {
  ordered_json json = headJson(diff.verdict, names);
  json.update(figuresJson(diff, true));
  json["limits"] = limitsJson(request);
  return core::jsonText(json);
}

std::string diffJson(const std::vector<Outcome>& outcomes, const DiffNames& names, const DiffRequest& request) {
  ordered_json json = outcomesJson(outcomes, names);
  json["limits"] = limitsJson(request);
  return core::jsonText(json);
}

std::string diffJson(const FilmDiff& diff, const DiffNames& names, const DiffRequest& request) {
  ordered_json json = headJson(diff.verdict(), names);
  json["mismatch"] = textOrNull(diff.mismatch);
  json["fps"] = core::toString(diff.fps);
  if (const PictureDiff summary = summaryOf(diff); summary.film) json["film"] = filmJson(*summary.film);
  if (!diff.frames.empty()) json["worst_frame"] = diff.worst();
  json["frames"] = ordered_json::array();
  for (const PictureDiff& frame : diff.frames) json["frames"].push_back(figuresJson(frame, false));
  json["limits"] = limitsJson(request);
  return core::jsonText(json);
}

}  // namespace poinsot::compare
