// SPDX-License-Identifier: Apache-2.0
#include "compare/diff_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <system_error>

#include "compare/alike.h"
#include "compare/diff_text.h"
#include "core/base64.h"
#include "core/regular_file.h"
#include "core/shell_word.h"
#include "figure/mark.h"
#include "image/png_file.h"
#include "request/picture_options.h"

// Contents of diff_page.html, .css, .js, diff_page_patch.js and diff_page_view.js, linked into the program.
extern "C" const char poinsot_diff_page[], poinsot_diff_page_end[];
extern "C" const char poinsot_diff_page_css[], poinsot_diff_page_css_end[];
extern "C" const char poinsot_diff_page_view[], poinsot_diff_page_view_end[];
extern "C" const char poinsot_diff_page_patch[], poinsot_diff_page_patch_end[];
extern "C" const char poinsot_diff_page_js[], poinsot_diff_page_js_end[];

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json dataUrl(const char* type, const std::string& bytes) {
  if (bytes.empty()) return nullptr;
  return fmt::format("data:{};base64,{}", type, core::base64(bytes));
}

/// Returns the path as a relative URL. All bytes except unreserved characters (RFC 3986) and slashes are
/// percent-encoded.
std::string urlOf(const fs::path& path) {
  std::string url;
  for (const unsigned char c : path.generic_string())
    url += std::isalnum(c) || std::string_view("-._~/").find(static_cast<char>(c)) != std::string_view::npos
               ? std::string(1, static_cast<char>(c))
               : fmt::format("%{:02X}", c);
  return url;
}

std::string urlFrom(const fs::path& page, const fs::path& file) {
  std::error_code failure;
  const fs::path folder = fs::absolute(page).parent_path();
  const fs::path relative = fs::proximate(fs::absolute(file), folder, failure);
  return urlOf(failure ? fs::absolute(file).lexically_proximate(folder) : relative);
}

ordered_json pictureJson(const DiffPagePicture& picture, const fs::path& page) {
  if (!picture.png.empty()) return dataUrl("image/png", picture.png);
  return picture.file.empty() ? ordered_json() : ordered_json(urlFrom(page, picture.file));
}

ordered_json factsJson(const DiffPageFacts& facts) {
  ordered_json json = ordered_json::array();
  for (const auto& [term, text] : facts)
    if (!text.empty()) json.push_back({term, text});
  return json;
}

DiffPageFacts factsOf(const DiffPageEntry& entry) {
  DiffPageFacts facts;
  if (entry.hasFigures && entry.diff.figures.differingPixels > 0)
    facts = termsOf(entry.diff, entry.pixelsPerDegree);
  if (entry.diff.ignoredShare > 0)
    facts.emplace_back("ignored", fmt::format("{:.3g} % of the picture", 100 * entry.diff.ignoredShare));
  facts.insert(facts.end(), entry.facts.begin(), entry.facts.end());
  return facts;
}

ordered_json ignoredJson(const PictureDiff& diff) {
  ordered_json boxes = ordered_json::array();
  for (const image::PixelRect& box : diff.ignored)
    boxes.push_back({box.left, box.top, box.right - box.left, box.bottom - box.top});
  return boxes;
}

/// Returns the changes of a row: in words, and as a list of places. Each place has left, top, width, height and
/// number of differing pixels.
ordered_json changeJson(const DiffPageEntry& entry) {
  const Changes& changes = entry.diff.changes;
  ordered_json places = ordered_json::array();
  for (const auto& [box, pixels] : changes.places)
    places.push_back({box.left, box.top, box.right - box.left, box.bottom - box.top, pixels});
  ordered_json json{{"change", wordsOf(changes)},
                    {"places", places},
                    {"place_count", changes.placeCount},
                    {"ignored", ignoredJson(entry.diff)}};
  if (entry.hasFigures && !entry.diff.figures.worst.empty()) {
    const DifferingPixel& worst = entry.diff.figures.worst.front();
    json["worst"] = {worst.x, worst.y};
  }
  return json;
}

ordered_json stateJson(const std::optional<FileState>& state) {
  if (!state) return nullptr;
  return {{"size", state->size}, {"sha256", state->sha256}, {"git", state->git}};
}

/// Returns the files that approve a row. page_approval.cpp and diff_page_patch.js read them. Null if there are
/// none.
ordered_json filesJson(const std::vector<ApprovalStep>& steps) {
  ordered_json files;
  for (const ApprovalStep& step : steps) {
    files.push_back(
        {{"place", step.place.generic_string()}, {"old", stateJson(step.before)}, {"new", stateJson(step.after)}});
    if (!step.text.empty()) files.back()["text"] = step.text;
    if (!step.source.empty())
      files.back().update({{"source", step.source.generic_string()}, {"embedded", step.isEmbedded}});
  }
  return files;
}

ordered_json entryJson(const DiffPageEntry& entry, const fs::path& page, const fs::path& root) {
  ordered_json json{{"name", entry.name}, {"status", entry.status}, {"message", entry.message}};
  const ImageDifference& d = entry.diff.figures;
  if (entry.hasFigures)
    json.update({{"max_difference", d.maxAbs},
                 {"differing_pixels", d.differingPixels},
                 {"flip_mean", d.flip.mean},
                 {"flip_max", d.flip.max}});
  json.update(changeJson(entry));
  json.update({{"facts", factsJson(factsOf(entry))},
               {"approve", entry.approve},
               {"files", filesJson(approvalSteps(entry.approval, root, page, entry.actual.png))},
               {"reference", pictureJson(entry.reference, page)},
               {"actual", pictureJson(entry.actual, page)},
               {"flip", pictureJson(entry.map, page)}});
  return json;
}

ordered_json curveJson(const std::optional<DiffPageCurve>& curve) {
  if (!curve) return nullptr;
  return {{"picture", dataUrl("image/svg+xml", curve->svg)},
          {"left", curve->left},
          {"right", curve->right},
          {"places", curve->placesOfEntries}};
}

/// Returns the groups of alike changes, with the numbers of their rows. The frames of a film are not grouped,
/// because neighbouring frames are always alike.
ordered_json groupsJson(const DiffPage& page) {
  ordered_json json = ordered_json::array();
  if (page.curve) return json;
  std::vector<const PictureDiff*> diffs;
  for (const DiffPageEntry& entry : page.entries) diffs.push_back(&entry.diff);
  for (const AlikeGroup& group : alikeChanges(diffs))
    json.push_back({{"kind", group.kind}, {"members", group.members}});
  return json;
}

ordered_json pageJson(const DiffPage& page) {
  ordered_json json{{"title", page.title},
                    {"verdict", page.verdict},
                    {"note", page.note},
                    {"counts", page.counts},
                    {"first", page.first},
                    {"entry", page.entry},
                    {"reference", page.reference},
                    {"actual", page.actual},
                    {"run", factsJson(page.run)},
                    {"approve", page.approve},
                    {"curve", curveJson(page.curve)},
                    {"entries", ordered_json::array()}};
  for (const DiffPageEntry& entry : page.entries)
    json["entries"].push_back(entryJson(entry, page.file, page.root));
  json["groups"] = groupsJson(page);
  const auto hasFiles = [](const ordered_json& entry) { return !entry["files"].is_null(); };
  if (std::ranges::any_of(json["entries"], hasFiles))
    json["approve"] = core::shellWords({"poinsot", "golden", "approve", page.file.native()});
  return json;
}

/// Reads a picture that the page embeds. Returns an empty picture if the file is unreadable.
/// @param inDoubt  whether to check that the file is a complete PNG
DiffPagePicture readPicture(const fs::path& file, bool inDoubt) try {
  std::string png = core::readRegularFile(file, request::kMostPicture, core::ErrorKind::kIo);
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(png.data()), png.size());
  if (inDoubt && !image::textsOfWholePng(bytes)) return {};
  return {std::move(png), file};
} catch (const core::Error&) {
  return {};
}

/// Returns the JSON for a script element. Escapes "<", so that no string in the JSON can end the element.
std::string scriptText(const ordered_json& json) {
  const std::string text = json.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
  std::string safe;
  for (const char c : text) c == '<' ? safe += "\\u003c" : safe += c;
  return safe;
}

/// Replaces the last occurrence of a mark, because earlier ones may be file names inside the data.
void fillIn(std::string& html, std::string_view mark, const std::string& text) {
  html.replace(html.rfind(mark), mark.size(), text);
}

}  // namespace

void EmbedBudget::admit(DiffPageEntry& entry) {
  constexpr std::size_t kMostRows = 100, kMostBytes = 50'000'000;
  std::size_t bytes = 0;
  const auto pictures = {&entry.reference, &entry.actual, &entry.map};
  for (const DiffPagePicture* picture : pictures) bytes += picture->png.size();
  if (bytes == 0) return;
  isSpent_ = isSpent_ || rows_ == kMostRows || bytes_ + bytes > kMostBytes;
  if (isSpent_) {
    for (DiffPagePicture* picture : pictures) picture->png.clear();
    return;
  }
  ++rows_;
  bytes_ += bytes;
}

std::vector<DiffPageEntry*> worstFirst(std::vector<DiffPageEntry>& entries) {
  std::vector<DiffPageEntry*> order;
  for (DiffPageEntry& entry : entries)
    if (entry.status != "identical") order.push_back(&entry);
  std::ranges::stable_sort(order, std::greater(), [](const DiffPageEntry* entry) { return badness(entry->diff); });
  return order;
}

void embedFiles(DiffPageEntry& entry) {
  for (DiffPagePicture* picture : {&entry.reference, &entry.actual, &entry.map})
    if (!picture->file.empty()) *picture = readPicture(picture->file, entry.status == "error");
}

output::FileKind reportKind() { return output::markedKind("a report", figure::kHtmlMark); }

std::string htmlOf(const DiffPage& page) {
  std::string html(poinsot_diff_page, poinsot_diff_page_end);
  fillIn(html, "@STYLE@", {poinsot_diff_page_css, poinsot_diff_page_css_end});
  fillIn(html, "@DATA@", scriptText(pageJson(page)));
  fillIn(html, "@SCRIPT@",
         std::string(poinsot_diff_page_view, poinsot_diff_page_view_end) +
             std::string(poinsot_diff_page_patch, poinsot_diff_page_patch_end) +
             std::string(poinsot_diff_page_js, poinsot_diff_page_js_end));
  return figure::marked(figure::kHtmlMark, html);
}

}  // namespace poinsot::compare
