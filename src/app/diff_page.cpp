// SPDX-License-Identifier: Apache-2.0
#include "app/diff_page.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/diff_text.h"
#include "core/base64.h"
#include "core/regular_file.h"
#include "output/figure_mark.h"

// Of diff_page.html.
extern "C" const char poinsot_diff_page[], poinsot_diff_page_end[];

namespace poinsot::app {
namespace {

using nlohmann::ordered_json;

ordered_json dataUrl(const char* type, const std::string& bytes) {
  if (bytes.empty()) return nullptr;
  return fmt::format("data:{};base64,{}", type, core::base64(bytes));
}

ordered_json pictureJson(const DiffPageEntry::Png& png) { return dataUrl("image/png", png); }

ordered_json factsJson(const DiffPageEntry& entry) {
  ordered_json facts = ordered_json::array();
  if (entry.hasFigures && entry.diff.figures.differingPixels > 0) {
    for (const auto& [term, text] : termsOf(entry.diff, entry.pixelsPerDegree))
      facts.push_back(ordered_json::array({term, text}));
    const image::DifferingPixel& worst = entry.diff.figures.worst.front();
    facts.push_back({"worst pixel", fmt::format("({}, {})", worst.x, worst.y)});
  }
  for (const auto& [term, text] : entry.facts)
    if (!text.empty()) facts.push_back({term, text});
  return facts;
}

ordered_json entryJson(const DiffPageEntry& entry) {
  ordered_json json{{"name", entry.name}, {"status", entry.status}, {"message", entry.message}};
  const image::ImageDifference& d = entry.diff.figures;
  if (entry.hasFigures)
    json.update({{"max_difference", d.maxAbs},
                 {"differing_pixels", d.differingPixels},
                 {"flip_mean", d.flip.mean},
                 {"flip_max", d.flip.max}});
  json.update({{"width", entry.diff.size.width},
               {"facts", factsJson(entry)},
               {"reference", pictureJson(entry.reference)},
               {"actual", pictureJson(entry.actual)},
               {"difference", pictureJson(entry.difference)},
               {"flip", pictureJson(entry.map)}});
  return json;
}

ordered_json curveJson(const std::optional<DiffPageCurve>& curve) {
  if (!curve) return nullptr;
  return {{"picture", dataUrl("image/svg+xml", curve->svg)},
          {"left", curve->left},
          {"right", curve->right},
          {"places", curve->placesOfEntries}};
}

ordered_json pageJson(const DiffPage& page) {
  ordered_json json{{"title", page.title},
                    {"verdict", page.verdict},
                    {"note", page.note},
                    {"counts", page.counts},
                    {"entry", page.entry},
                    {"reference", page.reference},
                    {"actual", page.actual},
                    {"curve", curveJson(page.curve)},
                    {"entries", ordered_json::array()}};
  for (const DiffPageEntry& entry : page.entries) json["entries"].push_back(entryJson(entry));
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

bool DiffPage::hasRoom() const {
  constexpr std::size_t kMost = std::size_t{192} << 20;
  std::size_t bytes = 0;
  for (const DiffPageEntry& e : entries)
    bytes += e.reference.size() + e.actual.size() + e.difference.size() + e.map.size();
  return bytes < kMost;
}

DiffPageEntry::Png pngFile(const std::filesystem::path& file) {
  constexpr std::size_t kMost = std::size_t{512} << 20;
  return core::readRegularFile(file, kMost, core::ErrorKind::kIo);
}

std::string htmlOf(const DiffPage& page) {
  std::string html(poinsot_diff_page, poinsot_diff_page_end);
  constexpr std::string_view kMark = "@DATA@";
  html.replace(html.find(kMark), kMark.size(), scriptText(pageJson(page)));
  return output::marked(output::kHtmlMark, html);
}

}  // namespace poinsot::app
