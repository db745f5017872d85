// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "render/renderer.h"

namespace poinsot::render {

/// A renderer on OSMesa and a few measures of its pictures.
class PictureTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { gl::pinEnvironment(true); }

  static constexpr image::PixelSize kSize{200, 160};

  /// Looks along -x at the origin from 10 away; 1 unit there is 80 pixels.
  static draw::DrawList emptyList() {
    draw::DrawList list;
    list.camera = draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 1.0f, {kSize.width, kSize.height});
    list.camera.tanHalfFovY = 0.1f;
    list.camera.near = 5;
    list.camera.far = 15;
    return list;
  }

  image::Image render(const draw::DrawList& list) { return renderer_.render(list, kSize); }

  /// Pixels' worth of darkness on white paper: the area of what is black, as blending is in linear light.
  static double blackArea(const image::Image& picture) {
    double area = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
      area += 1 - static_cast<double>(draw::linearFromSrgb8(picture.pixels[i]));
    return area;
  }

  /// A material that no light brightens.
  static draw::Material black() { return {draw::Color(0), 0.0f}; }

  std::unique_ptr<gl::OffscreenContext> context_ = gl::openContext(gl::Backend::kOsMesa);
  Renderer renderer_{*context_};
};

}  // namespace poinsot::render
