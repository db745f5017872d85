// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/renderer.h"

namespace poinsot::render {

class PictureTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { gl::pinEnvironment(true); }

  static constexpr image::PixelSize kSize{200, 160};

  /// Returns an empty list whose camera looks along -x at the origin from 10 away; 1 unit there is 80 pixels.
  static draw::DrawList emptyList() {
    draw::DrawList list;
    list.camera = draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 1.0f, {kSize.width, kSize.height});
    list.camera.tanHalfFovY = 0.1f;
    list.camera.near = 5;
    list.camera.far = 15;
    return list;
  }

  image::Image render(const draw::DrawList& list) { return renderer_.render(list, kSize); }

  /// Returns the area of black on white paper, in pixels. Sums darkness in linear light, because blending is
  /// linear.
  static double blackArea(const image::Image& picture) {
    double area = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
      area += 1 - static_cast<double>(draw::linearFromSrgb8(picture.pixels[i]));
    return area;
  }

  /// Difference of two pictures, in steps of 1/255 over all channels.
  struct Difference {
    int count = 0;    ///< values that differ at all
    double mean = 0;  ///< over the values that differ
    int worst = 0;
    float worstLight = 0;  ///< largest difference in linear light
    int beyond = 0;        ///< values that differ by more than a bound, in linear light
  };
  static Difference difference(const image::Image& a, const image::Image& b, float bound = 0) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    Difference d;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      const int step = std::abs(a.pixels[i] - b.pixels[i]);
      d.count += step > 0;
      d.mean += step;
      d.worst = std::max(d.worst, step);
      const float light = draw::linearFromSrgb8(a.pixels[i]) - draw::linearFromSrgb8(b.pixels[i]);
      d.worstLight = std::max(d.worstLight, std::abs(light));
      d.beyond += std::abs(light) > bound;
    }
    d.mean /= std::max(d.count, 1);
    return d;
  }

  /// Returns a black material that no light brightens.
  static draw::Material black() { return {draw::Color(0), 0.0f}; }

  std::unique_ptr<gl::OffscreenContext> context_ = gl::openContext(gl::Backend::kAuto);
  Renderer renderer_{*context_};
};

}  // namespace poinsot::render
