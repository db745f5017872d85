// SPDX-License-Identifier: Apache-2.0
// FLIP for low dynamic range, the steps and constants of the paper's sections 4.1 (colour) and 4.2 (features).
//
// Both paths work on planes of doubles: a picture is three planes in the linear opponent space Y Cx Cz. The colour
// path blurs them with the eye's contrast sensitivity, returns to linear RGB and measures in Hunt-adjusted CIELab;
// the feature path looks for edges and points in the unblurred luminance.
#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/expect.h"

namespace poinsot::image {
namespace {

using Triple = std::array<double, 3>;
using Plane = std::vector<double>;

constexpr double kPi = std::numbers::pi;

// ---- colour spaces

// Linear sRGB to XYZ, rational so that the white point is the sum of the columns to the last bit.
constexpr std::array<Triple, 3> kXyzFromRgb = {
    {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

constexpr Triple product(const std::array<Triple, 3>& m, const Triple& v) {
  Triple r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return r;
}

constexpr std::array<Triple, 3> inverse(const std::array<Triple, 3>& m) {
  const auto minor = [&](std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  std::array<Triple, 3> inv{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) inv[c][r] = minor(r, c) / determinant;
  return inv;
}

constexpr std::array<Triple, 3> kRgbFromXyz = inverse(kXyzFromRgb);
constexpr Triple kWhite = product(kXyzFromRgb, {1, 1, 1});

double linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// XYZ relative to white, from linear RGB.
Triple relativeXyz(const Triple& rgb) {
  const Triple xyz = product(kXyzFromRgb, rgb);
  return {xyz[0] / kWhite[0], xyz[1] / kWhite[1], xyz[2] / kWhite[2]};
}

Triple opponent(const Triple& rgb) {
  const auto [x, y, z] = relativeXyz(rgb);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Triple rgbOfOpponent(const Triple& yCxCz) {
  const double y = (yCxCz[0] + 16) / 116, x = y + yCxCz[1] / 500, z = y - yCxCz[2] / 200;
  Triple rgb = product(kRgbFromXyz, {x * kWhite[0], y * kWhite[1], z * kWhite[2]});
  for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
  return rgb;
}

/// CIELab whose chroma shrinks in the dark (Hunt effect).
Triple huntLab(const Triple& rgb) {
  constexpr double kDelta = 6.0 / 29;
  const auto f = [](double t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const auto [x, y, z] = relativeXyz(rgb);
  const double lightness = 116 * f(y) - 16;
  return {lightness, 0.01 * lightness * 500 * (f(x) - f(y)), 0.01 * lightness * 200 * (f(y) - f(z))};
}

double hyab(const Triple& a, const Triple& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// ---- convolution, edges clamped

/// Weights at offsets -r..r.
using Kernel = std::vector<double>;

template <class F>
Kernel sampled(int radius, F f) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(f(i));
  return kernel;
}

double sum(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); }

Plane alongRows(const Plane& in, PixelSize size, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  const auto width = static_cast<std::size_t>(size.width);
  Plane out(in.size()), padded(width + kernel.size() - 1);
  for (std::size_t start = 0; start < in.size(); start += width) {
    for (int x = -radius; x < size.width + radius; ++x)
      padded[static_cast<std::size_t>(x + radius)] =
          in[start + static_cast<std::size_t>(std::clamp(x, 0, size.width - 1))];
    for (std::size_t i = 0; i < kernel.size(); ++i)
      for (std::size_t x = 0; x < width; ++x) out[start + x] += kernel[i] * padded[x + i];
  }
  return out;
}

Plane alongColumns(const Plane& in, PixelSize size, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  const auto width = static_cast<std::size_t>(size.width);
  Plane out(in.size());
  for (int y = 0; y < size.height; ++y) {
    double* row = &out[static_cast<std::size_t>(y) * width];
    for (int i = -radius; i <= radius; ++i) {
      const double* source = &in[static_cast<std::size_t>(std::clamp(y + i, 0, size.height - 1)) * width];
      const double weight = kernel[static_cast<std::size_t>(i + radius)];
      for (std::size_t x = 0; x < width; ++x) row[x] += weight * source[x];
    }
  }
  return out;
}

Plane separable(const Plane& in, PixelSize size, const Kernel& alongX, const Kernel& alongY) {
  return alongColumns(alongRows(in, size, alongX), size, alongY);
}

// ---- colour

using Opponent = std::array<Plane, 3>;

Opponent opponentPlanes(const Image& picture) {
  std::array<double, 256> linearOf{};
  for (std::size_t v = 0; v < linearOf.size(); ++v) linearOf[v] = linear(static_cast<double>(v) / 255);
  Opponent planes;
  for (Plane& plane : planes) plane.reserve(picture.pixels.size() / 3);
  const auto step = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < picture.pixels.size(); i += step) {
    const std::uint8_t* p = &picture.pixels[i];
    const Triple o = opponent({linearOf[p[0]], linearOf[p[1]], linearOf[p[2]]});
    for (std::size_t c = 0; c < 3; ++c) planes[c].push_back(o[c]);
  }
  return planes;
}

/// One Gaussian of a contrast sensitivity function: weight a, width b in squared degrees.
struct Gaussian {
  double a = 0;
  double b = 0;
};

/// The kernel is the sum over its Gaussians of a √(π/b) exp(-π² (dx²+dy²)/b), scaled to sum 1. The root belongs to
/// the whole two-dimensional kernel: once per Gaussian, not once per direction.
Plane sensitivityBlur(const Plane& in, PixelSize size, const std::vector<Gaussian>& gaussians,
                      double pixelsPerDegree) {
  constexpr double kWidest = 0.04;  // of all channels: they share one radius
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixelsPerDegree));
  Plane out(in.size());
  double total = 0;
  for (const auto& [a, b] : gaussians) {
    const Kernel profile = sampled(radius, [&](int i) {
      const double d = i / pixelsPerDegree;
      return std::exp(-kPi * kPi * d * d / b);
    });
    const double weight = a * std::sqrt(kPi / b);
    const Plane blurred = separable(in, size, profile, profile);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * blurred[i];
    total += weight * sum(profile) * sum(profile);
  }
  for (double& v : out) v /= total;
  return out;
}

std::vector<Triple> perceivedColours(const Opponent& planes, PixelSize size, double pixelsPerDegree) {
  const Plane y = sensitivityBlur(planes[0], size, {{1, 0.0047}}, pixelsPerDegree);
  const Plane cx = sensitivityBlur(planes[1], size, {{1, 0.0053}}, pixelsPerDegree);
  const Plane cz = sensitivityBlur(planes[2], size, {{34.1, 0.04}, {13.5, 0.025}}, pixelsPerDegree);
  std::vector<Triple> colours(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) colours[i] = huntLab(rgbOfOpponent({y[i], cx[i], cz[i]}));
  return colours;
}

/// Colour difference in [0, 1]: 0.95 of the range for the small ones, where the eye tells more apart.
double colourError(const Triple& a, const Triple& b) {
  constexpr double kExponent = 0.7, kKnee = 0.4, kKneeValue = 0.95;
  static const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), kExponent);
  const double c = std::pow(hyab(a, b), kExponent), knee = kKnee * largest;
  if (c < knee) return kKneeValue * c / knee;
  return kKneeValue + (1 - kKneeValue) * (c - knee) / (largest - knee);
}

// ---- features

/// Scales the positive weights to sum 1 and the negative ones to sum -1.
Kernel balanced(Kernel kernel) {
  double positive = 0, negative = 0;
  for (const double w : kernel) (w > 0 ? positive : negative) += w;
  for (double& w : kernel) w /= w > 0 ? positive : -negative;
  return kernel;
}

/// Length of the response to `profile` along x and along y, each smoothed across.
Plane response(const Plane& luminance, PixelSize size, const Kernel& profile, const Kernel& smooth) {
  const Plane x = separable(luminance, size, profile, smooth), y = separable(luminance, size, smooth, profile);
  Plane length(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) length[i] = std::hypot(x[i], y[i]);
  return length;
}

struct Features {
  Plane edge;
  Plane point;
};

Features features(const Opponent& planes, PixelSize size, double pixelsPerDegree) {
  constexpr double kFeatureWidth_deg = 0.082;
  const double sigma = 0.5 * kFeatureWidth_deg * pixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const auto gauss = [&](int i) { return std::exp(-i * i / (2 * sigma * sigma)); };
  Kernel smooth = sampled(radius, gauss);
  const double total = sum(smooth);
  for (double& w : smooth) w /= total;
  const Kernel edge = balanced(sampled(radius, [&](int i) { return -i * gauss(i); }));
  const Kernel point = balanced(sampled(radius, [&](int i) { return (i * i / (sigma * sigma) - 1) * gauss(i); }));
  Plane luminance(planes[0]);
  for (double& v : luminance) v = (v + 16) / 116;
  return {response(luminance, size, edge, smooth), response(luminance, size, point, smooth)};
}

}  // namespace

double FlipMap::mean() const {
  return std::accumulate(error.begin(), error.end(), 0.0) / static_cast<double>(error.size());
}

double FlipMap::max() const { return *std::max_element(error.begin(), error.end()); }

FlipMap flip(const Image& a, const Image& b, double pixelsPerDegree) {
  POINSOT_EXPECT(a.size == b.size && !a.pixels.empty());
  const Opponent planesA = opponentPlanes(a), planesB = opponentPlanes(b);
  const auto coloursA = perceivedColours(planesA, a.size, pixelsPerDegree);
  const auto coloursB = perceivedColours(planesB, a.size, pixelsPerDegree);
  const Features featuresA = features(planesA, a.size, pixelsPerDegree);
  const Features featuresB = features(planesB, a.size, pixelsPerDegree);
  FlipMap map{a.size, Plane(coloursA.size())};
  for (std::size_t i = 0; i < map.error.size(); ++i) {
    const double edge = std::abs(featuresA.edge[i] - featuresB.edge[i]);
    const double point = std::abs(featuresA.point[i] - featuresB.point[i]);
    const double feature = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
    map.error[i] = std::pow(colourError(coloursA[i], coloursB[i]), 1 - feature);
  }
  return map;
}

}  // namespace poinsot::image
