// SPDX-License-Identifier: Apache-2.0
#include "draw/line_widths.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace poinsot::draw {
namespace {

/// Returns a picture whose only line is a stroke of 9 pixels.
Picture thickStroke() {
  Picture picture;
  picture.panels.resize(1);
  picture.strokes.push_back({.points_px = {{0, 0}, {1, 1}}, .width_px = 9});
  return picture;
}

// Each change adds a line of 0.5 pixels.
const std::vector<std::function<void(Picture&)>> kThinLines = {
    [](Picture& p) { p.panels[0].list.ellipsoids.emplace_back().marking_px = 0.5f; },
    [](Picture& p) {
      Mesh& mesh = p.panels[0].list.meshes.emplace_back();
      mesh.mesh = std::make_shared<TriangleMesh>();
      mesh.edge_px = 0.5f;
    },
    [](Picture& p) { p.panels[0].list.curves.emplace_back().width_px = 0.5f; },
    [](Picture& p) {
      Graticule& lines = p.panels[0].list.glassEllipsoids.emplace_back().graticule.emplace();
      lines.width_px = 0.5f;
      lines.opacity = 0;  // visible only on the far wall
    },
    [](Picture& p) { p.panels[0].list.glassCones.emplace_back().lineWidth_px = 0.5f; },
    [](Picture& p) { p.panels[0].list.glassPolygons.emplace_back().lineWidth_px = 0.5f; },
    [](Picture& p) { p.panels[0].list.planes.emplace_back().lineWidth_px = 0.5f; },
    [](Picture& p) {
      p.strokes.push_back({.points_px = {{0, 0}, {1, 1}}, .width_px = 0.5f});
    }};

TEST(ThinnestLine, FindsEveryKindOfLine) {
  for (std::size_t i = 0; i < kThinLines.size(); ++i) {
    Picture picture = thickStroke();
    EXPECT_EQ(thinnestLine_px(picture), 9.0f);
    kThinLines[i](picture);
    EXPECT_EQ(thinnestLine_px(picture), 0.5f) << "line " << i;
  }
}

TEST(ThinnestLine, IgnoresTubesAndInvisibleLines) {
  Picture picture = thickStroke();
  DrawList& list = picture.panels[0].list;
  list.ellipsoids.emplace_back();             // without markings
  list.meshes.emplace_back().edge_px = 0.5f;  // null mesh
  list.curves.push_back({.points_V = {}, .width_px = 0.5f, .radius_V = 0.1f, .material = {}});
  list.planes.push_back({.lineOpacity = 0, .lineWidth_px = 0.5f});
  list.glassCones.push_back({.lineOpacity = 0, .lineWidth_px = 0.5f});
  picture.strokes.push_back({.points_px = {}, .width_px = 0.5f, .opacity = 0});
  EXPECT_EQ(thinnestLine_px(picture), 9.0f);
}

TEST(ThinnestLine, IsAbsentInAPictureWithoutLines) { EXPECT_EQ(thinnestLine_px(Picture()), std::nullopt); }

}  // namespace
}  // namespace poinsot::draw
