// SPDX-License-Identifier: Apache-2.0
#include "compare/common_form.h"

#include <algorithm>
#include <utility>

#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {
namespace {

template <typename Sample>
bool isOpaque(const image::BasicImage<Sample>& picture) {
  if (picture.channels == 3) return true;
  for (int y = 0; y < picture.size.height; ++y) {
    core::checkInterruption();
    const Sample* p = picture.at(0, y);
    for (int x = 0; x < picture.size.width; ++x)
      if (p[4 * x + 3] != image::BasicImage<Sample>::kMost) return false;
  }
  return true;
}

/// Returns the picture with three or four channels; a new alpha channel is opaque.
template <typename Sample>
image::BasicImage<Sample> withChannels(image::BasicImage<Sample>&& picture, int channels) {
  if (picture.channels == channels) return std::move(picture);
  image::BasicImage<Sample> out(picture.size, channels);
  const Sample* from = picture.pixels.data();
  for (auto to = out.pixels.begin(); to != out.pixels.end(); from += picture.channels, to += channels) {
    for (int c = 0; c < 3; ++c) to[c] = from[c];  // std::copy_n would call memmove for each pixel
    if (channels == 4) to[3] = image::BasicImage<Sample>::kMost;
  }
  return out;
}

template <typename Sample>
void clearUnseen(image::BasicImage<Sample>& picture) {
  for (auto p = picture.pixels.begin(); p != picture.pixels.end(); p += 4)
    if (p[3] == 0) std::fill_n(p, 3, Sample{0});
}

template <typename Sample>
void toCommonChannels(image::BasicImage<Sample>& a, image::BasicImage<Sample>& b) {
  const int channels = isOpaque(a) && isOpaque(b) ? 3 : 4;
  for (auto* picture : {&a, &b}) {
    *picture = withChannels(std::move(*picture), channels);
    if (channels == 4) clearUnseen(*picture);
  }
}

}  // namespace

void toCommonForm(image::AnyImage& a, image::AnyImage& b) {
  if (a.index() != b.index()) {
    a = image::deepened(a);
    b = image::deepened(b);
  }
  std::visit([&](auto& first) { toCommonChannels(first, std::get<std::decay_t<decltype(first)>>(b)); }, a);
}

template <typename Sample>
image::BasicImage<Sample> onPaper(const image::BasicImage<Sample>& picture, Sample paper) {
  POINSOT_EXPECT(picture.channels == 4);
  constexpr std::uint64_t kMost = image::BasicImage<Sample>::kMost;
  image::BasicImage<Sample> out(picture.size, 3);
  auto to = out.pixels.begin();
  for (auto p = picture.pixels.begin(); p != picture.pixels.end(); p += 4)
    for (int c = 0; c < 3; ++c)
      *to++ = static_cast<Sample>((p[c] * std::uint64_t{p[3]} + paper * (kMost - p[3]) + kMost / 2) / kMost);
  return out;
}

template image::Image onPaper(const image::Image& picture, std::uint8_t paper);
template image::DeepImage onPaper(const image::DeepImage& picture, std::uint16_t paper);

}  // namespace poinsot::compare
