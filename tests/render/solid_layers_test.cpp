// SPDX-License-Identifier: Apache-2.0
// llvmpipe compiles shaders anew for textures with a side of 2^n (lp_sampler_static_texture_state of Mesa 22.3 has
// pot_width and pot_height). Layers therefore have no such side, for any part of any picture.
#include "render/solid_layers.h"

#include <gtest/gtest.h>

#include <bit>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <memory>

#include "gl/offscreen_context.h"

namespace poinsot::render {
namespace {

PixelBounds part(glm::ivec2 size) {
  return {0, 0, static_cast<float>(size.x - 1), static_cast<float>(size.y - 1)};
}

bool hasPowerOfTwo(glm::ivec2 size) {
  return std::has_single_bit(static_cast<unsigned>(size.x)) || std::has_single_bit(static_cast<unsigned>(size.y));
}

class SolidLayersTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { gl::pinEnvironment(true); }

  /// Returns the size of the layers after they were fitted to a part of a picture.
  glm::ivec2 fit(SolidLayers& layers, glm::ivec2 size, glm::ivec2 picture) {
    layers.fit(part(size), picture, GL_RGBA8);
    return layers[SolidLayer::kFull].size();
  }

 private:
  std::unique_ptr<gl::OffscreenContext> context_ = gl::openContext(gl::Backend::kAuto);
};

TEST_F(SolidLayersTest, AreLargeEnoughAndHaveNoSideThatIsAPowerOfTwo) {
  for (const glm::ivec2 picture : {glm::ivec2(1920, 1080), {1023, 511}, {512, 256}})
    for (int share = 1; share <= 32; ++share) {
      SolidLayers layers;
      const glm::ivec2 size = glm::max(picture * share / 32, 1), made = fit(layers, size, picture);
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(made, size))) << made.x << " x " << made.y;
      EXPECT_FALSE(hasPowerOfTwo(made)) << made.x << " x " << made.y;
    }
}

TEST_F(SolidLayersTest, AvoidPowersOfTwoWhenTheyGrowOrThePictureShrinks) {
  SolidLayers layers;
  for (int side = 100; side <= 1000; side += 100)
    EXPECT_FALSE(hasPowerOfTwo(fit(layers, {side, 50}, {1920, 1080})));
  EXPECT_EQ(fit(layers, {100, 50}, {1920, 1080}).x, 1025);  // layers keep their size
  EXPECT_FALSE(hasPowerOfTwo(fit(layers, {300, 500}, {1023, 511})));
}

}  // namespace
}  // namespace poinsot::render
