// SPDX-License-Identifier: Apache-2.0
#include "cli/notes.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/text.h"
#include "describe/report_loop.h"
#include "draw/line_widths.h"
#include "gl/offscreen_context.h"
#include "request/requested_scene.h"
#include "scene/motion/heavy_top_start.h"
#include "scene/motion/make_motion.h"
#include "stage/palette.h"
#include "stage/stage.h"
#include "stage/type/crowded_text.h"
#include "stage/type/lettering.h"

namespace poinsot::cli {

namespace {

constexpr double kPointsPerInch = 72;
constexpr double kTexPoint_pt = 72 / 72.27;  // point of options, in points of 1/72 inch

std::string line(const std::string& text) { return "poinsot: " + text + "\n"; }

/// Returns the film time of one nutation as text. Empty unless the motion is a heavy top with a finite period.
std::string nutationText(const scene::Scene& scene, double pace) {
  const auto top = scene::heavyTopStart(scene);
  const double period_s = top ? top->nutation().period_s / pace : 0;
  if (!(period_s > 0) || !std::isfinite(period_s)) return "";
  return fmt::format(" a nutation takes {:.3g} s of film;", period_s);
}

/// Returns a note that the program has chosen a playback speed at which the motion can be followed. Otherwise,
/// users may think that the film is in real time.
std::string paceNote(const scene::Scene& scene) {
  const double pace = scene::chosenSpeed(scene);
  if (scene.time.speed || std::abs(pace - 1) < 0.05) return "";
  return line(
      fmt::format("a second of film is {:.3g} s of the motion, the whole film {:.3g} s;{} time.speed = 1 shows "
                  "the motion in real time",
                  pace, pace * scene.time.duration_s, nutationText(scene, pace)));
}

/// Returns a note if the path of a flight is drawn at a smaller scale than the body.
std::string flightNote(const scene::Scene& scene) {
  if (!scene.motion.flight || scene.show.figures.flight.scale) return "";
  const double scale = stage::Stage(scene).flightScale();
  if (scale >= 1) return "";
  return line(fmt::format(
      "the flight path is drawn {:.3g} times smaller than the body, because the body would otherwise be too small "
      "to see; show.flight.scale = 1 draws the path to scale, and camera.follow = true moves the camera with the "
      "body, so that both are drawn to scale",
      1 / scale));
}

std::string torqueNote(const scene::Scene& scene) {
  const auto asks = [](const scene::View& view) { return view.show.figures.torque.visible; };
  if (!scene.motion.isFree() || std::ranges::none_of(scene.views, asks)) return "";
  return line("show.torque has no effect, because no torque acts on the body");
}

std::string faintTypeNote(const scene::Scene& scene) {
  constexpr double kLegible = 3;  // minimum contrast of large text (WCAG 2)
  const stage::Palette colors = stage::palette(scene.style);
  const double contrast = stage::contrastRatio(colors.ink, colors.paper);
  if (contrast >= kLegible) return "";
  return line(
      fmt::format("titles hardly stand out from the paper (contrast {:.2g} : 1); set style.colors.ink, or a "
                  "style.theme with a similar paper colour",
                  contrast));
}

float smallestType_px(const draw::Picture& picture) {
  float smallest = std::numeric_limits<float>::infinity();
  const auto look = [&](const std::vector<draw::Text>& texts) {
    for (const draw::Text& text : texts) smallest = std::min(smallest, text.size_px);
  };
  look(picture.texts);
  for (const draw::Panel& panel : picture.panels) look(panel.list.texts);
  return smallest;
}

bool isHall(const scene::Style& style) { return style.preset == scene::StylePreset::kHall; }

/// Returns whether a camera of the scene may leave out a part of the motion.
bool isAimed(const scene::Scene& scene) {
  const auto aims = [](const scene::View& view) { return view.camera.zoom > 1 || !view.camera.shift.isZero(0); };
  const auto zooms = [](const scene::TimelineEntry& entry) { return entry.zoom.value_or(1) > 1; };
  return std::ranges::any_of(scene.views, aims) || std::ranges::any_of(scene.timeline.entries, zooms);
}

/// Returns a note if text does not have the size that --type sets, or does not fit.
std::string fixedTypeNote(double asked_pt, double smallest_pt, const draw::Picture& picture) {
  constexpr std::string_view kAdvice =
      "make the figure larger, or have fewer panels, fewer words or a smaller --type";
  if (smallest_pt < asked_pt * (1 - 1e-3))
    return line(
        fmt::format("--type: the smallest text is {:.2g} pt high, because a text of {:.3g} pt is too wide "
                    "for its place; {}",
                    smallest_pt / kTexPoint_pt, asked_pt / kTexPoint_pt, kAdvice));
  const std::string crowded = stage::crowdedText(picture);
  if (crowded.empty()) return "";
  return line(
      fmt::format("--type: text of {:.3g} pt has no room: '{}' overlaps other text or leaves the picture; {}",
                  asked_pt / kTexPoint_pt, core::printable(crowded), kAdvice));
}

std::string thinLineNote(const job::RenderRequest& render, const draw::Picture& picture) {
  constexpr double kThinnest_pt = 0.25;  // minimum line width that publishers accept
  if (!render.form.print) return "";
  const auto thinnest_px = draw::thinnestLine_px(picture);
  const double thin_pt =
      thinnest_px ? static_cast<double>(*thinnest_px) * kPointsPerInch / render.form.print->dpi : kThinnest_pt;
  if (std::round(100 * thin_pt) >= 100 * kThinnest_pt) return "";
  const double key = scene::lineWidthKey(render.scene.scene.style) * kThinnest_pt / thin_pt;
  return line(
      fmt::format("the thinnest line is {:.2f} pt wide; many journals ask for {} pt: set style.line_width = "
                  "{:.2f}, or have fewer panels or cells",
                  thin_pt, kThinnest_pt, std::ceil(100 * key) / 100));
}

std::string smallTypeNote(const job::RenderRequest& render, const draw::Picture& picture) {
  constexpr double kLegible_px = 7;  // text size at which the letter x is 3 pixels high
  constexpr double kLegible_pt = 5;  // minimum text size that publishers accept
  const auto& [sweep, print] = std::tie(render.scene.request.sweep, render.form.print);
  const bool hall = !print && isHall(render.scene.scene.style);
  const double smallest_px = smallestType_px(picture), share = smallest_px / picture.size_px.y;
  if (hall && share < stage::kHallType * (1 - 1e-6))
    return line(
        fmt::format("the smallest text is {:.2g} % of the picture's height, less than the {:.2g} % of style "
                    "\"hall\"; fewer {} make it larger",
                    100 * share, 100 * stage::kHallType, sweep ? "cells" : "panels or words"));
  if (!sweep && !print) return "";
  const double smallest = print ? smallest_px * kPointsPerInch / print->dpi : smallest_px;
  if (print && print->type_pt) return fixedTypeNote(*print->type_pt, smallest, picture);
  if (smallest >= (print ? kLegible_pt : kLegible_px)) return "";
  return line(
      fmt::format("the smallest text is {:.2g} {}; a larger {} or fewer {} make it larger", smallest,
                  print ? "pt high, which is hard to read on paper" : "px high, which is too small to read",
                  print ? "--width" : "--size", sweep ? "cells" : "panels"));
}

std::string cutOffNote(const draw::Picture& picture) {
  if (std::ranges::none_of(picture.panels, [](const draw::Panel& panel) { return panel.list.isCutOff; }))
    return "";
  return line(
      "camera.zoom or camera.shift leaves a part of the motion outside the picture, at this time or another");
}

}  // namespace

std::string doubtNotes(const scene::Scene& scene) {
  std::string notes;
  for (const scene::Doubt& doubt : scene.doubts) notes += toString(doubt) + "\n";
  return notes;
}

std::string choiceNotes(const scene::Scene& scene, bool film) {
  std::string notes = doubtNotes(scene);
  if (scene.time.loop) notes += line(describe::loopText(scene));
  if (film) notes += paceNote(scene);
  return notes + flightNote(scene) + torqueNote(scene) + faintTypeNote(scene);
}

std::string pictureNotes(const job::RenderRequest& render) {
  const scene::Scene& scene = render.scene.scene;
  const bool isSmall = render.scene.request.sweep || render.form.print || isHall(scene.style);
  if (!isSmall && !isAimed(scene)) return "";  // to compose a picture, the motion must be computed
  const glm::ivec2 size_px(scene.output.width, scene.output.height);
  const stage::Moment moment(render.time_s.value_or(scene.time.stillTime_s()), true);
  const draw::Picture picture =
      request::composerOf(render.scene)
          ->compose(moment, size_px, request::sizingOf(render.form, scene.style, size_px));
  return smallTypeNote(render, picture) + thinLineNote(render, picture) + cutOffNote(picture);
}

std::string rendererNotes(const std::set<std::string>& renderers) {
  std::string notes;
  for (const std::string& renderer : renderers) {
    const std::string doubt = renderer.empty() ? "" : gl::rendererDoubt(renderer);
    if (!doubt.empty()) notes += "poinsot: note: " + core::printable(doubt) + "\n";
  }
  return notes;
}

}  // namespace poinsot::cli
