// SPDX-License-Identifier: Apache-2.0
// Tests what the CPU computes for a mesh's pixels: marks, areas of fragments, and which fragments hide others.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "random.h"
#include "render/pixel_fragment.h"
#include "render/pixel_marks.h"

namespace poinsot::render {
namespace {

using glm::dvec2;
using glm::dvec3;
using Triangle = std::array<dvec3, 3>;

double areaOf(const Triangle& t) {
  return ((t[1].y - t[0].y) * (t[2].x - t[0].x) - (t[1].x - t[0].x) * (t[2].y - t[0].y)) / 2;
}

// Returns a triangle that faces the eye.
Triangle randomTriangle(Random& random, float size_px) {
  Triangle t;
  for (dvec3& v : t) v = {random.in(0, size_px), random.in(0, size_px), random.in(8, 12)};
  if (areaOf(t) < 0) std::swap(t[0], t[1]);
  return t;
}

TEST(PixelFragment, PartsOfATriangleAddUpToItsArea) {
  Random random;
  double worst = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Triangle t = randomTriangle(random, trial % 2 ? 12.0f : 2.0f);
    double area = 0;
    dvec2 moment(0);
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x)
        if (const auto f = pixelFragment(t, {x, y})) {
          area += f->area;
          moment += f->area * (f->middle + dvec2(x, y));
        }
    const dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    worst = std::max(worst, std::abs(area - areaOf(t)));
    EXPECT_NEAR(area, areaOf(t), 1e-6);
    EXPECT_LT(glm::distance(moment, areaOf(t) * dvec2(middle)), 1e-5);
  }
  RecordProperty("worst_area", std::to_string(worst));  // measured 1.5e-7; parts below 1e-7 are left out
}

// In perspective, 1 / depth is linear in the picture; weights and depth must give back a plane in space.
TEST(PixelFragment, WeightsAndDepthAreCorrectInPerspective) {
  Random random;
  const auto inSpace = [](dvec3 p) {
    return dvec3(p.x * p.z, p.y * p.z, p.z);
  };  // focal length 1, optical axis at 0
  for (int trial = 0; trial < 200; ++trial) {
    const Triangle t = randomTriangle(random, 6);
    for (int i = 0; i < 36; ++i) {
      const glm::ivec2 pixel(i % 6, i / 6);
      const auto f = pixelFragment(t, pixel);
      if (!f || areaOf(t) < 0.1) continue;
      dvec3 x(0);
      for (int k = 0; k < 3; ++k) x += f->weights[k] * inSpace(t[static_cast<std::size_t>(k)]);
      EXPECT_NEAR(x.z, f->depth, 1e-9);
      EXPECT_LT(glm::distance(dvec2(x) / x.z, f->middle + dvec2(pixel)), 1e-9);
      EXPECT_LE(f->near, f->depth);
      EXPECT_GE(f->far, f->depth);
    }
  }
}

// Returns the fragment left of `x` of a surface at a depth, which faces the eye and is far larger than the pixel.
PixelFragment leftOf(double x, double depth) {
  return *pixelFragment({dvec3(x, -50, depth), dvec3(-100, 0, depth), dvec3(x, 50, depth)}, {0, 0});
}
PixelFragment rightOf(double x, double depth) {
  return *pixelFragment({dvec3(x, 50, depth), dvec3(100, 0, depth), dvec3(x, -50, depth)}, {0, 0});
}

TEST(VisibleAreas, AreExactForFragmentsThatDoNotOverlap) {
  const std::array fragments{leftOf(0.3137, 10), rightOf(0.3137, 10)};
  const auto areas = visibleAreas(fragments);
  EXPECT_NEAR(areas[0], 0.3137, 1e-12);
  EXPECT_NEAR(areas[1], 0.6863, 1e-12);
}

TEST(VisibleAreas, GiveTheFarFragmentTheRestOfThePixel) {
  const std::array fragments{rightOf(-1, 12), leftOf(0.3137, 10)};  // the first fills the pixel
  const auto areas = visibleAreas(fragments);
  EXPECT_NEAR(areas[1], 0.3137, 1e-12);
  EXPECT_NEAR(areas[0], 0.6863, 1e-12);
}

TEST(VisibleAreas, AreZeroForWhollyHiddenFragments) {
  const std::array fragments{leftOf(0.2, 12), leftOf(0.5, 10), leftOf(1e-4, 11)};
  const auto areas = visibleAreas(fragments);
  EXPECT_EQ(areas[0], 0);
  EXPECT_NEAR(areas[1], 0.5, 1e-12);
  EXPECT_EQ(areas[2], 0);  // too small for any sample
}

// With open paper beside both fragments, the hidden share is an estimate by 64 samples.
TEST(VisibleAreas, AreEstimatedForAPartlyHiddenFragment) {
  for (double edge = 0.05; edge < 0.6; edge += 0.05) {
    const std::array fragments{leftOf(0.7, 12), leftOf(edge, 10)};
    const auto areas = visibleAreas(fragments);
    EXPECT_NEAR(areas[1], edge, 1e-12);
    EXPECT_NEAR(areas[0], 0.7 - edge, 0.02);  // measured 0.012
  }
}

// Expected: every pixel found by walking along the segment in small steps.
TEST(PixelMarks, IncludeEveryPixelOfASegmentAndFewOthers) {
  Random random;
  for (int trial = 0; trial < 300; ++trial) {
    PixelMarks marks;
    marks.reset({40, 30}, {0, 0, 40, 30});
    const dvec2 a{random.in(-10, 50), random.in(-10, 40)}, b{random.in(-10, 50), random.in(-10, 40)};
    marks.markSegment(a, b);
    marks.finish();
    std::vector<char> crossed(40 * 30);
    for (int i = 0; i <= 20000; ++i) {
      const dvec2 p = a + (b - a) * (i / 20000.0);
      if (p.x >= 0 && p.y >= 0 && p.x < 40 && p.y < 30)
        crossed[static_cast<std::size_t>(int(p.y) * 40 + int(p.x))] = 1;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < crossed.size(); ++i) {
      if (crossed[i]) {
        EXPECT_EQ(marks.bytes()[i], PixelMarks::kMarked);
      }
      count += static_cast<std::size_t>(crossed[i]);
    }
    EXPECT_LE(marks.count(), count + 4) << trial;  // corners touched within the margin
  }
}

TEST(PixelMarks, AreNumberedRowByRow) {
  PixelMarks marks;
  marks.reset({8, 4}, {0, 0, 8, 4});
  marks.markSegment({1.5, 1.5}, {3.5, 1.5});
  marks.markSegment({6.5, 3.5}, {6.5, 9});
  marks.finish();
  ASSERT_EQ(marks.count(), 4);
  EXPECT_EQ(marks.firstOfRow(1), 0);
  EXPECT_EQ(marks.firstOfRow(2), 3);
  EXPECT_EQ(marks.firstOfRow(3), 3);
  EXPECT_EQ(marks.firstOfRow(4), 4);
  EXPECT_EQ(marks.columns()[2], 3);
  EXPECT_EQ(marks.columns()[3], 6);
}

TEST(PixelMarks, StayWithinTheGivenPart) {
  PixelMarks marks;
  marks.reset({8, 6}, {0, 0, 8, 6});
  marks.mark({0, 0, 8, 6});
  marks.reset({8, 6}, {2.5, 1, 5, 4});  // columns 2 to 4
  EXPECT_EQ(marks.bytes()[0], 0);       // earlier marks are gone
  marks.markSegment({-9, 2.5}, {20, 2.5});
  marks.mark({3, 3, 4, 9});
  marks.finish();
  ASSERT_EQ(marks.count(), 4);
  EXPECT_EQ(marks.firstOfRow(2), 0);
  EXPECT_EQ(marks.firstOfRow(3), 3);
  EXPECT_EQ(marks.firstOfRow(6), 4);
  EXPECT_EQ(marks.columns()[0], 2);
  EXPECT_EQ(marks.columns()[3], 3);
  EXPECT_EQ(marks.bytes()[8 + 0], PixelMarks::kMarked);  // column 2 of row 2
  EXPECT_EQ(marks.bytes()[8 + 3], 0);
}

}  // namespace
}  // namespace poinsot::render
