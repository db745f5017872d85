// SPDX-License-Identifier: Apache-2.0
// The picture cut into rectangles by what is there: held to what a pixel would be asked for itself, at sizes that
// tiles and cells do not fit into.
#include "render/mosaic.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "draw/camera.h"

namespace poinsot::render {
namespace {

constexpr int kWidth = 330, kHeight = 210;

draw::DrawList ellipsoidOverPlane() {
  draw::DrawList list;
  list.camera = draw::lookAt({9, 2, 4}, glm::vec3(0), {0, 0, 1}, 1.0f, {kWidth, kHeight});
  list.camera.tanHalfFovY = 0.15f;
  list.camera.near = 5;
  list.camera.far = 15;
  draw::GlassEllipsoid glass;
  glass.semiAxes_W = glm::mat3(0.6f);
  list.glassEllipsoids = {glass};
  draw::GridPlane plane;
  plane.centre_W = {0, 0, -0.6f};
  plane.u_W = {1, 0, 0};
  plane.v_W = {0, 1, 0};
  list.planes = {plane};
  return list;
}

SolidCells someSolids() {
  SolidCells cells(glm::vec2(kWidth, kHeight));
  cells.nextSolid();
  cells.markSolid(PixelBounds{130, 70, 215, 120}, {1, 2});
  cells.markEdge(PixelBounds{130, 70, 215, 74});
  cells.nextStrand();
  cells.markEdge(PixelBounds{200, 60, 205, 200});
  return cells;
}

/// The content of each pixel, and how often it is covered.
struct Unfolded {
  std::vector<int> times = std::vector<int>(kWidth * kHeight);
  std::vector<const Content*> contents = std::vector<const Content*>(kWidth * kHeight);

  explicit Unfolded(const Mosaic& mosaic) {
    for (const auto& [content, parts] : mosaic.parts)
      for (const PixelBounds& part : parts)
        for (int y = static_cast<int>(part.top); y < static_cast<int>(part.bottom); ++y)
          for (int x = static_cast<int>(part.left); x < static_cast<int>(part.right); ++x) {
            ++times.at(static_cast<std::size_t>(y * kWidth + x));
            contents.at(static_cast<std::size_t>(y * kWidth + x)) = &content;
          }
  }
};

template <typename Use>
void forEachPixel(Use use) {
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) use(x, y, static_cast<std::size_t>(y * kWidth + x));
}

TEST(Mosaic, CoversItsColumnsOnceAndNothingElse) {
  const draw::DrawList list = ellipsoidOverPlane();
  const Mosaic mosaic = cutIntoMosaic(list.camera.size_px, Sheets(list), someSolids());
  const Unfolded all(mosaic);
  ASSERT_EQ(mosaic.columns.size(), 4u);
  forEachPixel([&](int x, int y, std::size_t i) {
    const Mosaic::Span& span = mosaic.columns[static_cast<std::size_t>(y / Mosaic::kTile_px)];
    EXPECT_EQ(all.times[i], x >= span.from && x < span.to ? 1 : 0) << x << ", " << y;
  });
}

// What a pixel's own square may show is drawn there; where no outline is drawn, each sheet fills it.
TEST(Mosaic, LeavesOutNothingThatAPixelShows) {
  const draw::DrawList list = ellipsoidOverPlane();
  const Sheets sheets(list);
  const SolidCells solids = someSolids();
  const Mosaic mosaic = cutIntoMosaic(list.camera.size_px, sheets, solids);
  const Unfolded all(mosaic);
  int withOutlines = 0, filled = 0;
  forEachPixel([&](int x, int y, std::size_t i) {
    const PixelBounds pixel{static_cast<float>(x), static_cast<float>(y), static_cast<float>(x + 1),
                            static_cast<float>(y + 1)};
    const Content own{solids.reach(pixel)[1], sheets.reaching(pixel)};
    if (own.empty()) return;
    ASSERT_NE(all.contents[i], nullptr) << x << ", " << y;
    const Content& drawn = *all.contents[i];
    EXPECT_GE(drawn.solids, own.solids) << x << ", " << y;
    EXPECT_TRUE(std::ranges::includes(drawn.sheets.ellipsoids, own.sheets.ellipsoids)) << x << ", " << y;
    EXPECT_TRUE(std::ranges::includes(drawn.sheets.planes, own.sheets.planes)) << x << ", " << y;
    if (drawn.sheets.outlines) return void(++withOutlines);
    ++filled;
    EXPECT_EQ(drawn.sheets, own.sheets) << x << ", " << y;
  });
  EXPECT_GT(withOutlines, 1000);
  EXPECT_GT(filled, 1000);
}

TEST(Mosaic, OfNothingIsEmpty) {
  const draw::DrawList list = [] {
    draw::DrawList empty = ellipsoidOverPlane();
    empty.glassEllipsoids.clear();
    empty.planes.clear();
    return empty;
  }();
  const Mosaic mosaic = cutIntoMosaic(list.camera.size_px, Sheets(list), SolidCells(list.camera.size_px));
  EXPECT_TRUE(mosaic.parts.empty());
  for (const Mosaic::Span& span : mosaic.columns) EXPECT_TRUE(span.empty());
}

}  // namespace
}  // namespace poinsot::render
