// SPDX-License-Identifier: Apache-2.0
#include "preview/preview_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/error.h"
#include "core/frame_clock.h"
#include "core/text.h"
#include "describe/report.h"
#include "describe/report_units.h"
#include "describe/timeline_words.h"
#include "scene/state_quantity.h"
#include "stage/picture_motion.h"
#include "stage/quantity_track.h"

namespace poinsot::preview {
namespace {

using nlohmann::json;

constexpr std::size_t kMostPoints = 1000;

/// Returns JSON text in ASCII. Replaces invalid UTF-8.
std::string text(const json& value) { return value.dump(-1, ' ', true, json::error_handler_t::replace); }

json quantityJson(const scene::StateQuantity& quantity) {
  return {{"name", quantity.name}, {"help", quantity.help}, {"unit", scene::unitText(quantity.unit)}};
}

json physicsOf(const scene::Scene& scene, const request::UnitChoice& units) {
  json sections = json::array();
  const describe::Report report = describe::inUnits(describe::sceneReport(scene), units);
  for (const describe::Section& section : report.sections) {
    if (section.facts.empty()) continue;
    json facts = json::array();
    for (const describe::Fact& fact : section.facts)
      facts.push_back({{"label", fact.label}, {"lines", describe::factLines(fact)}, {"from", fact.from}});
    sections.push_back({{"title", section.title}, {"facts", std::move(facts)}});
  }
  return sections;
}

double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }

json cameraJson(const scene::Camera& camera) {
  return {{"azimuth", degrees(camera.azimuth_rad)},
          {"elevation", degrees(camera.elevation_rad)},
          {"zoom", camera.zoom}};
}

json viewsOf(const scene::Scene& scene) {
  json views = json::array();
  for (const scene::View& view : scene.views)
    views.push_back({{"title", view.title}, {"camera", cameraJson(view.camera)}});
  return views;
}

json notesOf(const scene::Scene& scene) {
  json notes = json::array();
  for (const scene::Doubt& doubt : scene.doubts) notes.push_back(toString(doubt));
  return notes;
}

json timelineOf(const scene::Scene& scene) {
  json entries = json::array();
  for (const describe::TimelineWords& entry : describe::timelineWords(scene))
    entries.push_back({{"at_s", entry.at_s}, {"moment", entry.moment}, {"text", entry.text}});
  return entries;
}

/// @param sweep  whether `scene` is the first cell of a sweep, in which the page rotates all cameras together
json filmOf(const scene::Scene& scene, bool sweep, const request::UnitChoice& units) {
  json quantities = json::array();
  for (const scene::StateQuantity& quantity : scene::stateQuantities())
    quantities.push_back(quantityJson(quantity));
  return {{"frames", core::frameCount(scene.time.duration_s, scene.time.fps)},
          {"fps", static_cast<double>(scene.time.fps.num) / static_cast<double>(scene.time.fps.den)},
          {"duration_s", scene.time.duration_s},
          {"size", {scene.output.width, scene.output.height}},
          {"camera", cameraJson(scene.camera)},
          {"sweep", sweep},
          {"panels", sweep ? 1 : scene.views.size() + scene.plots.size()},
          {"views", sweep ? json::array() : viewsOf(scene)},
          {"ownViews", scene.ownViews},
          {"notes", notesOf(scene)},
          {"timeline", timelineOf(scene)},
          {"physics", physicsOf(scene, units)},
          {"quantities", std::move(quantities)}};
}

int indexOf(const std::string& name) {
  const auto all = scene::stateQuantities();
  const auto found = std::ranges::find(all, name, &scene::StateQuantity::name);
  if (found == all.end())
    throw core::usageError(fmt::format("{}: no quantity has this name", core::printable(name)));
  return static_cast<int>(found - all.begin());
}

/// Returns the value, or null if it is not finite, because JSON has no NaN and no infinity.
json numberOrNull(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

}  // namespace

std::string sceneJson(const SceneVersion& version, const request::UnitChoice& units) {
  json all{{"version", version.number}, {"error", version.error}, {"file", version.request.fileName}};
  if (version.scene) all["film"] = filmOf(*version.scene, version.request.sweep.has_value(), units);
  return text(all);
}

std::string seriesJson(const scene::Scene& scene, const std::vector<std::string>& names) {
  std::vector<int> quantities;
  for (const std::string& name : names) quantities.push_back(indexOf(name));
  const stage::QuantityTrack track(scene, stage::drawnMotion(scene), quantities);
  const std::size_t points = std::min(track.samples(), kMostPoints);
  json all{{"times_s", json::array()}, {"series", json::array()}};
  const auto sampleOf = [&](std::size_t i) { return points < 2 ? 0 : i * (track.samples() - 1) / (points - 1); };
  for (std::size_t i = 0; i < points; ++i) all["times_s"].push_back(track.filmTime_s(sampleOf(i)));
  for (std::size_t which = 0; which < quantities.size(); ++which) {
    json one = quantityJson(track.quantity(which));
    for (std::size_t i = 0; i < points; ++i)
      one["values"].push_back(numberOrNull(track.sample(which, sampleOf(i))));
    all["series"].push_back(std::move(one));
  }
  return text(all);
}

std::string filmJson(const FilmState& state) {
  constexpr const char* kStages[] = {"none", "making", "ready", "failed"};
  return text({{"stage", kStages[static_cast<std::size_t>(state.stage)]},
               {"done", state.done},
               {"total", state.total},
               {"changes", state.changes},
               {"text", state.text}});
}

}  // namespace poinsot::preview
