// SPDX-License-Identifier: Apache-2.0
#include "cli/notes.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/text.h"
#include "describe/report_loop.h"
#include "gl/offscreen_context.h"
#include "request/requested_scene.h"
#include "scene/motion/heavy_top_start.h"
#include "scene/motion/make_motion.h"
#include "stage/palette.h"
#include "stage/stage.h"

namespace poinsot::cli {

namespace {

constexpr double kPointsPerInch = 72;

std::string line(const std::string& text) { return "poinsot: " + text + "\n"; }

/// Returns the film time of a nutation; empty if the motion is no heavy top, or has no finite nutation period.
std::string nutationText(const scene::Scene& scene, double pace) {
  const auto top = scene::heavyTopStart(scene);
  const double period_s = top ? top->nutation().period_s / pace : 0;
  if (!(period_s > 0) || !std::isfinite(period_s)) return "";
  return fmt::format(" a nutation takes {:.3g} s of film;", period_s);
}

/// Returns a note on a speed that the program chose so that the eye can follow. Such a film can be mistaken for
/// real time, and may be too slow to show much of the motion.
std::string paceNote(const scene::Scene& scene) {
  const double pace = scene::chosenSpeed(scene);
  if (scene.time.speed || std::abs(pace - 1) < 0.05) return "";
  return line(
      fmt::format("a second of film is {:.3g} s of the motion, the whole film {:.3g} s;{} time.speed = 1 is as "
                  "fast as it is",
                  pace, pace * scene.time.duration_s, nutationText(scene, pace)));
}

/// Returns a note if the path of a flight was shrunk so that the body can be seen, because it looks true to scale.
std::string flightNote(const scene::Scene& scene) {
  if (!scene.motion.flight || scene.show.figures.flight.scale) return "";
  const double scale = stage::Stage(scene).flightScale();
  if (scale >= 1) return "";
  return line(
      fmt::format("beside the body the path of its flight is drawn {:.3g} times smaller, or the body would be too "
                  "small to see; a shorter film needs less of it, show.flight.scale = 1 none",
                  1 / scale));
}

std::string torqueNote(const scene::Scene& scene) {
  const auto asks = [](const scene::View& view) { return view.show.figures.torque.visible; };
  if (!scene.motion.forcing.none() || std::ranges::none_of(scene.views, asks)) return "";
  return line("show.torque asks for a torque, and nothing acts on the body");
}

std::string faintTypeNote(const scene::Scene& scene) {
  constexpr double kLegible = 3;  // contrast of large type (WCAG 2)
  const stage::Palette colors = stage::palette(scene.style);
  const double contrast = stage::contrastRatio(colors.ink, colors.paper);
  if (contrast >= kLegible) return "";
  return line(
      fmt::format("titles hardly stand out from the paper (contrast {:.2g} : 1); give style.colors.ink, or a "
                  "style.theme whose paper is like yours",
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

}  // namespace

std::string doubtNotes(const scene::Scene& scene) {
  std::string notes;
  for (const scene::Doubt& doubt : scene.doubts) notes += toString(doubt) + "\n";
  return notes;
}

std::string choiceNotes(const scene::Scene& scene, bool film) {
  std::string notes = doubtNotes(scene);
  if (scene.time.loop) notes += line(describe::loopText(*scene.time.loop, scene.time));
  if (film) notes += paceNote(scene);
  return notes + flightNote(scene) + torqueNote(scene) + faintTypeNote(scene);
}

std::string smallTypeNote(const job::RenderRequest& render) {
  constexpr double kLegible_px = 7;  // the letter x is then 3 pixels high
  constexpr double kLegible_pt = 5;  // least size that publishers accept
  const auto& [sweep, print] = std::tie(render.scene.request.sweep, render.form.print);
  if (!sweep && !print) return "";
  const scene::Scene& scene = render.scene.scene;
  const glm::ivec2 size_px(scene.output.width, scene.output.height);
  const stage::Moment moment(render.time_s.value_or(scene.time.stillTime_s()), true);
  const double smallest_px = smallestType_px(
      request::composerOf(render.scene)->compose(moment, size_px, request::sizingOf(render.form, size_px)));
  const double smallest = print ? smallest_px * kPointsPerInch / print->dpi : smallest_px;
  if (smallest >= (print ? kLegible_pt : kLegible_px)) return "";
  return line(fmt::format("the smallest type is {:.2g} {}; a larger {} or fewer {} make it larger", smallest,
                          print ? "pt high, which is hard to read on paper" : "px high, which nobody can read",
                          print ? "--width" : "--size", sweep ? "cells" : "panels"));
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
