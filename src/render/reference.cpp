// SPDX-License-Identifier: Apache-2.0
#include "render/reference.h"

#include <vector>

#include "core/expect.h"
#include "render/text_painter.h"

namespace poinsot::render {
namespace {

constexpr float kHard = 1e4f;

}  // namespace

image::Image renderReference(Renderer& renderer, const draw::DrawList& list, image::PixelSize size, int n) {
  POINSOT_EXPECT(n > 0);
  draw::DrawList shifted = list;
  shifted.texts.clear();
  std::vector<double> sum;
  for (int i = 0; i < n * n; ++i) {
    const auto offset = [&](int k) { return (static_cast<float>(k) + 0.5f) / static_cast<float>(n) - 0.5f; };
    shifted.camera.centre_px = list.camera.centre_px - glm::vec2(offset(i % n), offset(i / n));
    const image::Image sample = renderer.render(shifted, size, {.sharpness = kHard});
    sum.resize(sample.pixels.size());
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += static_cast<double>(draw::linearFromSrgb8(sample.pixels[k]));
  }
  image::Image picture(size, 3);
  for (std::size_t k = 0; k < sum.size(); ++k)
    picture.pixels[k] = draw::srgb8FromLinear(static_cast<float>(sum[k] / (n * n)));
  TextPainter().paint(list.texts, picture);
  return picture;
}

}  // namespace poinsot::render
