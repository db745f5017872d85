// SPDX-License-Identifier: Apache-2.0
#include "compare/change_measures.h"

#include <algorithm>

#include "core/expect.h"

namespace poinsot::compare {
namespace {

template <typename Sample, typename Equal>
bool holds(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b, Equal equal) {
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x)
      if (!equal(x, y, b.at(x, y))) return false;
  return true;
}

template <typename Sample>
std::optional<Symmetry> found(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b) {
  POINSOT_EXPECT(a.size == b.size && a.channels == b.channels && a.pixels != b.pixels);
  const int width = a.size.width, height = a.size.height;
  const auto isFrom = [&](int x, int y, const Sample* q) { return std::equal(q, q + a.channels, a.at(x, y)); };
  if (holds(a, b, [&](int x, int y, const Sample* q) { return isFrom(x, height - 1 - y, q); }))
    return Symmetry::kUpsideDown;
  if (holds(a, b, [&](int x, int y, const Sample* q) { return isFrom(width - 1 - x, y, q); }))
    return Symmetry::kMirrored;
  const auto isExchanged = [&](int x, int y, const Sample* q) {
    const Sample* p = a.at(x, y);
    return q[0] == p[2] && q[1] == p[1] && q[2] == p[0] && (a.channels == 3 || q[3] == p[3]);
  };
  return holds(a, b, isExchanged) ? std::optional(Symmetry::kRedAndBlueExchanged) : std::nullopt;
}

}  // namespace

std::optional<Symmetry> symmetryOf(const image::Image& reference, const image::Image& test) {
  return found(reference, test);
}
std::optional<Symmetry> symmetryOf(const image::DeepImage& reference, const image::DeepImage& test) {
  return found(reference, test);
}

}  // namespace poinsot::compare
