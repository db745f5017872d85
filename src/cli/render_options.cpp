// SPDX-License-Identifier: Apache-2.0
#include "cli/render_options.h"

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/option_values.h"
#include "core/error.h"
#include "core/number.h"
#include "core/text.h"
#include "scene/document/problem.h"
#include "scene/limits.h"
#include "scene/sweep.h"

namespace poinsot::cli {
namespace {

std::vector<std::string> qualityNames() {
  std::vector<std::string> names;
  for (const scene::QualityPreset& preset : scene::qualityPresets()) names.emplace_back(preset.name);
  return names;
}

/// Returns the overrides for -q. They include size and CRF, to replace those of the file.
std::vector<std::string> qualityOverrides(const std::string& quality) {
  if (quality.empty()) return {};
  std::vector<std::string> overrides{"output.quality=" + quality};
  if (const auto* preset = scene::qualityPreset(quality)) {
    overrides.push_back(fmt::format("output.size=[{}, {}]", preset->width, preset->height));
    overrides.push_back(fmt::format("output.crf={}", preset->crf));
  }
  return overrides;
}

struct Override {
  std::string text;   ///< override, such as "time.fps=0"
  std::string typed;  ///< option as typed, such as "--fps 0"
};

std::vector<Override> overridesOf(const RenderOptions& options) {
  std::vector<Override> overrides;
  if (!options.times.empty()) overrides.push_back({instantsOverride(options.times), "--times " + options.times});
  for (const std::string& text : qualityOverrides(options.quality))
    overrides.push_back({text, "-q " + options.quality});
  for (const std::string& text : options.overrides) overrides.push_back({text, "-D " + text});
  if (!options.fps.empty()) overrides.push_back({"time.fps=" + options.fps, "--fps " + options.fps});
  if (options.loop) overrides.push_back({"time.loop=true", "--loop"});
  return overrides;
}

/// Returns whether an override, or the value of a cell in its range, is the place of a problem.
bool isOf(const Override& override, const std::string& place) {
  if (place == core::printable("-D " + override.text)) return true;
  return override.typed.starts_with("--times") && place.starts_with(fmt::format("-D {}=", scene::kInstantKey));
}

/// Throws the errors again, with options as the user typed them. In the original errors, all options look like -D.
[[noreturn]] void throwAsTyped(const scene::SceneErrors& errors, const std::vector<Override>& overrides) {
  std::vector<scene::Problem> problems = errors.problems();
  for (scene::Problem& problem : problems)
    for (const Override& override : overrides)
      if (isOf(override, problem.where.file)) problem.where.file = core::printable(override.typed);
  throw scene::SceneErrors(std::move(problems), errors.omitted());
}

}  // namespace

void addLookOptions(const Command& command, RenderOptions& options) {
  command.option("--size", options.size, "size of the picture in pixels").type("WxH").notEmpty();
  command.option("-q,--quality", options.quality, "size and quality").type("NAME").notEmpty(qualityNames());
  command.flag("--force", options.force, "replace a file that this program did not write");
  command.option("--backend", options.backend, "OpenGL back end: osmesa, egl, or auto for the first that works")
      .type("NAME")
      .among({"auto", "osmesa", "egl"});
}

void addPictureOptions(const Command& command, RenderOptions& options) {
  addLookOptions(command, options);
  command
      .option("-j,--jobs", options.jobs,
              "number of worker processes (default: one per CPU); the output does not depend on it")
      .type("N")
      .range(1, 1024);
  command.flag("--quiet", options.quiet, "print only errors");
  command.flag("--reproducible", options.reproducible, "draw the same pixels on every x86-64 CPU");
  command.flag("--dry-run", options.dryRun, "check everything, print what would be made, make nothing");
}

void addViewOption(const Command& command, RenderOptions& options) {
  command.option("--view", options.view, "only the N-th view, as the whole picture; counted from 1")
      .type("N")
      .range(1, 1'000'000);
}

void addRenderOptions(const Command& command, RenderOptions& options) {
  addSceneOptions(command, options);
  addViewOption(command, options);
  addPictureOptions(command, options);
  command.option("--progress", options.progress, "auto, plain, json (one object per line on stderr) or none")
      .type("STYLE")
      .among({"auto", "plain", "json", "none"});
  command.flag("--stats", options.stats, "at the end, print the CPU time per frame by step, and the peak memory");
  command
      .option("--trace", options.trace,
              "also write a JSON timeline of all workers, for chrome://tracing or ui.perfetto.dev")
      .type("FILE")
      .notEmpty();
}

image::PixelSize parseSize(const std::string& text, const scene::Limits& limits) {
  const auto cross = text.find('x');
  const auto width = core::parseInteger<int>(std::string_view(text).substr(0, cross));
  const auto height = cross == std::string::npos
                          ? std::nullopt
                          : core::parseInteger<int>(std::string_view(text).substr(cross + 1));
  if (!width || !height)
    throw core::usageError(
        fmt::format("--size '{}': must be WIDTHxHEIGHT, such as 1280x720", core::printable(text)));
  const std::int64_t most = limits[scene::Limit::kSide];
  const auto fits = [&](int side) { return side >= scene::kLeastSide && side <= most; };
  if (!fits(*width) || !fits(*height))
    throw core::limitError(fmt::format("--size {}x{}: sides must be from {} to {} pixels; {}", *width, *height,
                                       scene::kLeastSide, most, howToRaise(scene::Limit::kSide)));
  return {*width, *height};
}

request::RequestedScene requestedScene(const RenderOptions& options) {
  return requestedScene(options, granted(options));
}

request::RequestedScene requestedScene(const RenderOptions& options, const scene::Allowance& allowance) {
  const auto overrides = overridesOf(options);
  std::vector<std::string> texts;
  for (const Override& override : overrides) texts.push_back(override.text);
  auto request = request::readSceneRequest(options.scene, std::move(texts), allowance);
  request.sweep = options.sweep;
  if (options.view > 0) request.view = static_cast<std::size_t>(options.view - 1);
  if (!options.size.empty()) request.size = parseSize(options.size, allowance.limits);
  try {
    return request::requestedScene(std::move(request));
  } catch (const scene::SceneErrors& errors) {
    throwAsTyped(errors, overrides);
  }
}

gl::Backend requestedBackend(const RenderOptions& options) {
  if (options.backend == "osmesa") return gl::Backend::kOsMesa;
  return options.backend == "egl" ? gl::Backend::kEgl : gl::Backend::kAuto;
}

}  // namespace poinsot::cli
