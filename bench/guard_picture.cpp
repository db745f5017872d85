// SPDX-License-Identifier: Apache-2.0
#include "guard_picture.h"

#include <algorithm>
#include <cmath>

namespace poinsot::bench {
namespace {

struct Color {
  double r, g, b;
};

constexpr Color kWhite{1, 1, 1}, kGlass{0.75, 0.78, 0.8}, kInk{0.3, 0.3, 0.35}, kAmber{1, 0.6, 0.2},
    kBlue{0.25, 0.45, 0.75};

Color mixed(const Color& below, const Color& above, double share) {
  return {below.r + share * (above.r - below.r), below.g + share * (above.g - below.g),
          below.b + share * (above.b - below.b)};
}

Color shaded(const Color& color, double light) { return {light * color.r, light * color.g, light * color.b}; }

/// Returns the share of a pixel that lies inside an edge at a distance of `inside_px`.
double coverage(double inside_px) { return std::clamp(inside_px + 0.5, 0.0, 1.0); }

/// Returns the share of a pixel that is covered by lines of width `width_px`, which are `step_px` apart.
double lineCoverage(double at_px, double step_px, double width_px) {
  const double off_px = std::abs(at_px - step_px * std::floor(at_px / step_px + 0.5));
  return coverage(width_px / 2 - off_px);
}

/// Draws the plane. Coordinates are in heights of the picture from its middle, y up; `px` is pixels per height.
Color plane(const Color& below, double x, double y, double px) {
  const double inside_px = px * (-0.05 - std::abs(y + 0.2) + 0.2);
  const double depth = 1 / (1.2 - y);  // lines converge towards the horizon
  const double lines =
      std::max(lineCoverage(px * x * depth, px * 0.09, 1.5), lineCoverage(px * depth, px * 0.05, 1));
  return mixed(below, mixed(kGlass, kInk, lines), 0.35 * coverage(inside_px) + 0.3 * coverage(inside_px) * lines);
}

Color ellipsoid(const Color& below, double x, double y, double px) {
  const double u = x / 0.42, v = (y - 0.1 * x) / 0.3, square = u * u + v * v;
  const double inside = coverage(px * 0.3 * (1 - std::sqrt(square)));
  if (inside == 0) return below;
  const double depth = std::sqrt(std::max(0.0, 1 - square));
  const double light = 0.15 + 0.8 * std::max(0.0, 0.5 * depth + 0.6 * v - 0.3 * u);
  const double lines =
      std::max(lineCoverage(px * v, px * 0.2, 5), lineCoverage(px * u / (0.3 + depth), px * 0.2, 5));
  return mixed(below, shaded(mixed(kAmber, kInk, lines), light), 0.35 * inside + 0.4 * inside * lines);
}

Color box(const Color& below, double x, double y, double px) {
  const double along = x + 0.3 * y, up = y - 0.2 * x;
  const double inside_px = px * std::min(0.2 - std::abs(along), 0.06 - std::abs(up));
  return mixed(below, shaded(kBlue, up > 0.02 ? 0.95 : 0.6), coverage(inside_px));
}

std::uint8_t byteOf(double value) { return static_cast<std::uint8_t>(255 * std::clamp(value, 0.0, 1.0) + 0.5); }

}  // namespace

image::Image guardPicture(image::PixelSize size, double shift_px) {
  image::Image picture(size, 3);
  const double px = size.height;
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      const double x = (column + 0.5 - shift_px - size.width / 2.0) / px, y = (size.height / 2.0 - row - 0.5) / px;
      const Color color = ellipsoid(box(plane(kWhite, x, y, px), x, y, px), x, y, px);
      std::uint8_t* pixel = picture.at(column, row);
      pixel[0] = byteOf(color.r), pixel[1] = byteOf(color.g), pixel[2] = byteOf(color.b);
    }
  return picture;
}

}  // namespace poinsot::bench
