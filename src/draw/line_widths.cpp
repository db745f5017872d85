// SPDX-License-Identifier: Apache-2.0
#include "draw/line_widths.h"

#include <algorithm>

namespace poinsot::draw {
namespace {

class Thinnest {
 public:
  /// Takes a line into account. A line without width or opacity is not drawn.
  void add(float width_px, float opacity = 1) {
    if (width_px > 0 && opacity > 0) least_px_ = std::min(least_px_.value_or(width_px), width_px);
  }
  void addAll(const DrawList& list);
  std::optional<float> least_px() const { return least_px_; }

 private:
  std::optional<float> least_px_;
};

void Thinnest::addAll(const DrawList& list) {
  for (const Ellipsoid& e : list.ellipsoids) add(e.marking_px);
  for (const Mesh& m : list.meshes)
    if (m.mesh) add(m.edge_px);
  for (const Curve& c : list.curves)
    if (!(c.radius_V > 0)) add(c.width_px);
  for (const GlassEllipsoid& g : list.glassEllipsoids)
    if (g.graticule) add(g.graticule->width_px, std::max(g.graticule->opacity, g.graticule->farOpacity));
  for (const GlassCone& g : list.glassCones) add(g.lineWidth_px, g.lineOpacity);
  for (const GlassPolygon& g : list.glassPolygons) add(g.lineWidth_px, g.lineOpacity);
  for (const GridPlane& g : list.planes) add(g.lineWidth_px, g.lineOpacity);
}

}  // namespace

std::optional<float> thinnestLine_px(const Picture& picture) {
  Thinnest thinnest;
  for (const Panel& panel : picture.panels) thinnest.addAll(panel.list);
  for (const Stroke& stroke : picture.strokes) thinnest.add(stroke.width_px, stroke.opacity);
  return thinnest.least_px();
}

}  // namespace poinsot::draw
