// SPDX-License-Identifier: Apache-2.0
#include "preview/program_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/frame_clock.h"
#include "request/sweep_cells.h"

namespace poinsot::preview {
namespace {

using Words = std::vector<std::string>;

constexpr StillFormat kFormats[] = {{"png", ".png", ".png", "image/png"},
                                    {"pdf", ".pdf", ".pdf", "application/pdf"},
                                    {"svg", ".svg", ".svg", "image/svg+xml"},
                                    {"tex", ".tex", ".tex", "application/x-tex"},
                                    {"tex-image", ".tex", "-unlabelled.png", "image/png"}};

bool isSweep(const PreviewRequest& request) { return request::hasRanges(request.overrides); }

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

/// Returns the arguments for an override. The option and a value that begins with a dash are one argument, so that
/// the value does not count as an option.
Words overrideWords(const std::string& override) {
  if (override.starts_with('-')) return {"-D" + override};
  return {"-D", override};
}

/// Returns a command with its scene, `options`, the changes of the page, and the options of the preview.
Words commandWords(const std::string& command, const Words& options, const PreviewRequest& request,
                   const PageChanges& changes) {
  const bool dashed = request.fileName.starts_with('-');
  Words words{command};
  if (!dashed) words.push_back(request.fileName);
  append(words, options);
  for (const std::string& override : request.overrides) append(words, overrideWords(override));
  for (const std::string& override : changes.overrides) append(words, overrideWords(override));
  if (changes.view) append(words, {"--view", std::to_string(*changes.view + 1)});
  append(words, request.filmWords);
  if (dashed) append(words, {"--", request.fileName});
  return words;
}

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

const StillFormat* stillFormat(std::string_view word) {
  const auto* const found = std::ranges::find(kFormats, word, &StillFormat::word);
  return found == std::end(kFormats) ? nullptr : found;
}

double frameTime_s(const scene::Scene& scene, std::int64_t frame) {
  const std::int64_t count = core::frameCount(scene.time.duration_s, scene.time.fps);
  return core::filmTime_s(std::clamp<std::int64_t>(frame, 0, count - 1), scene.time.fps);
}

std::string stillName(const PreviewRequest& request, double time_s) {
  std::string stem = std::filesystem::path(request.fileName).stem().string();
  std::ranges::replace_if(
      stem, [](char c) { return !isPlain(c); }, '_');
  return fmt::format("{}{}_{}ms", stem, isSweep(request) ? "_sweep" : "", std::llround(1000 * time_s));
}

std::vector<std::string> stillWords(const PreviewRequest& request, const PageChanges& changes, double time_s,
                                    const std::string& target) {
  return commandWords(isSweep(request) ? "sweep" : "still", {"--time", fmt::format("{}", time_s), "-o", target},
                      request, changes);
}

std::vector<std::string> filmWords(const PreviewRequest& request, const PageChanges& changes,
                                   const std::string& target) {
  Words options{"--progress=json"};
  if (!target.empty()) append(options, {"-o", target});
  return commandWords(isSweep(request) ? "sweep" : "render", options, request, changes);
}

}  // namespace poinsot::preview
