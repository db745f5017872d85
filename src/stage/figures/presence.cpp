// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/presence.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

constexpr float kPen = 3;  // factor on the progress: lines reach their full width at a third of it

template <class T>
std::span<T> since(std::vector<T>& all, std::size_t before) {
  return std::span(all).subspan(before);
}

float lengthOf(const draw::Curve& curve) {
  float length = 0;
  for (std::size_t i = 1; i < curve.points_V.size(); ++i)
    length += glm::distance(curve.points_V[i - 1], curve.points_V[i]);
  if (curve.closed && !curve.points_V.empty())
    length += glm::distance(curve.points_V.back(), curve.points_V.front());
  return length;
}

void shorten(draw::Curve& curve, float length) {
  std::vector<glm::vec3> whole = std::move(curve.points_V);
  if (curve.closed) whole.push_back(whole.front());
  curve.closed = false;
  curve.points_V = {whole.front()};
  for (std::size_t i = 1; i < whole.size() && length > 0; ++i) {
    const float step = glm::distance(whole[i - 1], whole[i]);
    const float share = step > length ? length / step : 1;
    curve.points_V.push_back(whole[i - 1] + share * (whole[i] - whole[i - 1]));
    length -= step;
  }
}

/// Returns the presence of an object before the timeline's first change: 0 if the timeline shows the object before
/// hiding it, otherwise 1.
double initialOf(const scene::Timeline& timeline, int thing) {
  for (const scene::TimelineEntry& entry : timeline.entries) {
    if (std::ranges::find(entry.shown, thing) != entry.shown.end()) return 0;
    if (std::ranges::find(entry.hidden, thing) != entry.hidden.end()) return 1;
  }
  return 1;
}

scene::EasedTrack trackOf(const scene::Timeline& timeline, int thing) {
  scene::EasedTrack track(initialOf(timeline, thing));
  for (const scene::TimelineEntry& entry : timeline.entries) {
    if (std::ranges::find(entry.shown, thing) != entry.shown.end()) track.turnTo(entry.at_s, entry.over_s, 1);
    if (std::ranges::find(entry.hidden, thing) != entry.hidden.end()) track.turnTo(entry.at_s, entry.over_s, 0);
  }
  return track;
}

}  // namespace

PresencePlan::PresencePlan(const scene::Timeline& timeline) {
  if (timeline.entries.empty()) return;
  for (std::size_t i = 0; i < scene::timelineThings().size(); ++i)
    tracks_.push_back(trackOf(timeline, static_cast<int>(i)));
}

double PresencePlan::at(std::string_view thing, double filmTime_s) const {
  const auto& things = scene::timelineThings();
  const auto found = std::ranges::find(things, thing);
  if (tracks_.empty() || found == things.end()) return 1;
  return tracks_[static_cast<std::size_t>(found - things.begin())].at(filmTime_s);
}

DrawMark::DrawMark(const draw::DrawList& list, const std::vector<Label>& labels)
    : ellipsoids_(list.ellipsoids.size()),
      frustums_(list.frustums.size()),
      boxes_(list.boxes.size()),
      meshes_(list.meshes.size()),
      curves_(list.curves.size()),
      glassEllipsoids_(list.glassEllipsoids.size()),
      glassCones_(list.glassCones.size()),
      glassPolygons_(list.glassPolygons.size()),
      planes_(list.planes.size()),
      texts_(list.texts.size()),
      points_(list.points.size()),
      labels_(labels.size()) {}

void DrawMark::fade(draw::DrawList& list, std::vector<Label>& labels, const Eigen::Vector3d& pivot_V,
                    double presence) const {
  const auto p = static_cast<float>(presence);
  growSolids(list, toPicture(pivot_V), p);
  drawLines(list, p);
  thinGlass(list, p);
  for (draw::Text& text : since(list.texts, texts_)) text.opacity *= p;
  for (Label& label : since(labels, labels_)) {
    label.opacity *= p;
    label.presence *= p;
  }
}

void DrawMark::growSolids(draw::DrawList& list, const glm::vec3& pivot_V, float p) const {
  const auto towards = [&](glm::vec3& point_V) { point_V = pivot_V + p * (point_V - pivot_V); };
  for (draw::Ellipsoid& e : since(list.ellipsoids, ellipsoids_)) {
    towards(e.centre_V);
    e.semiAxes_V *= p;
    e.marking_px *= p;
  }
  for (draw::Frustum& f : since(list.frustums, frustums_)) {
    towards(f.from_V);
    towards(f.to_V);
    f.fromRadius *= p;
    f.toRadius *= p;
  }
  for (draw::Box& b : since(list.boxes, boxes_)) {
    towards(b.centre_V);
    b.halfAxes_V *= p;
  }
  for (draw::Mesh& m : since(list.meshes, meshes_)) {
    towards(m.origin_V);
    m.axes_V *= p;
    m.edge_px *= p;
  }
  for (draw::NamedPoint& point : since(list.points, points_)) towards(point.at_V);
}

void DrawMark::drawLines(draw::DrawList& list, float p) const {
  float whole = 0;
  for (const draw::Curve& curve : since(list.curves, curves_)) whole += lengthOf(curve);
  const float pen = std::min(1.0f, kPen * p);
  float left = p * whole;
  std::size_t drawn = curves_;
  for (draw::Curve& curve : since(list.curves, curves_)) {
    if (!(left > 0)) break;
    const float length = lengthOf(curve);
    if (length > left) shorten(curve, left);
    left -= length;
    curve.width_px *= pen;
    curve.radius_V *= pen;
    ++drawn;
  }
  list.curves.resize(drawn);
}

void DrawMark::thinGlass(draw::DrawList& list, float p) const {
  for (draw::GlassEllipsoid& g : since(list.glassEllipsoids, glassEllipsoids_)) {
    for (float* opacity : {&g.nearOpacity, &g.farOpacity, &g.rimOpacity}) *opacity *= p;
    if (g.graticule) g.graticule->opacity *= p;
    if (g.graticule) g.graticule->farOpacity *= p;
  }
  for (draw::GlassCone& g : since(list.glassCones, glassCones_))
    for (float* opacity : {&g.nearOpacity, &g.farOpacity, &g.rimOpacity, &g.lineOpacity}) *opacity *= p;
  for (draw::GlassPolygon& g : since(list.glassPolygons, glassPolygons_))
    for (float* opacity : {&g.opacity, &g.lineOpacity}) *opacity *= p;
  for (draw::GridPlane& g : since(list.planes, planes_))
    for (float* opacity : {&g.opacity, &g.lineOpacity, &g.shadowOpacity}) *opacity *= p;
}

}  // namespace poinsot::stage
