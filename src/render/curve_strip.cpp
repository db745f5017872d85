// SPDX-License-Identifier: Apache-2.0
#include "render/curve_strip.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

namespace poinsot::render {
namespace {

constexpr float kRamp_px = 1.0f;
constexpr float kShortest_px = 0.25f;  // neighbouring points closer than this are merged
// Largest distance of a left-out point from the line between its neighbours: kOff_px in the picture,
// kOffAlongView_px along the view. The second limit keeps a line in front of the surface on which it lies.
constexpr float kOff_px = 0.02f;
constexpr float kOffAlongView_px = 0.05f;
// Limit of consecutive points that are left out. Each further point requires a check of all of them.
constexpr std::size_t kMostLeftOut = 15;
// cosine of the largest bend; a larger bend is a fold, at which a new strip begins
constexpr float kFoldCosine = 0.0f;
constexpr float kEndless = 1e4f;  // distance to the end of a curve that stands for "no end nearby"

struct ScreenPoint {
  glm::vec2 p_px;
  float halfWidth_px;
  float depth;
  glm::vec4 tangent_C;
};

using Run = std::vector<ScreenPoint>;

// Returns the points in front of the camera, as one run for each unbroken part of the curve. Leaves out points
// closer than a quarter pixel to the previous point.
std::vector<Run> visibleRuns(const draw::Camera& camera, const draw::Curve& curve) {
  const std::size_t n = curve.points_V.size();
  const auto at = [&](std::size_t i) { return toCamera(camera, curve.points_V[i % n]); };
  std::vector<Run> runs(1);
  for (std::size_t i = 0; i < n + (curve.closed ? 1 : 0); ++i) {
    const glm::vec3 p_C = at(i);
    if (-p_C.z <= camera.near) {
      if (!runs.back().empty()) runs.emplace_back();
      continue;
    }
    const glm::vec3 before = curve.closed ? at(i + n - 1) : at(i > 0 ? i - 1 : 0);
    const glm::vec3 after = curve.closed ? at(i + 1) : at(std::min(i + 1, n - 1));
    const glm::vec3 along = after - before;
    const float length = glm::length(along);
    const glm::vec3 tangent = length > 0 ? along / length : glm::vec3(1, 0, 0);
    const float halfWidth = curve.radius_V > 0 ? curve.radius_V * camera.scale_px(-p_C.z) : 0.5f * curve.width_px;
    const ScreenPoint point{projectCamera(camera, p_C), halfWidth, -p_C.z, glm::vec4(tangent, curve.radius_V)};
    Run& run = runs.back();
    const bool last = i + 1 == n + (curve.closed ? 1 : 0);
    if (!run.empty() && glm::distance(run.back().p_px, point.p_px) < kShortest_px && !last) continue;
    run.push_back(point);
  }
  return runs;
}

bool isStraight(const draw::Camera& camera, const ScreenPoint& from, std::span<const ScreenPoint> between,
                const ScreenPoint& to) {
  const glm::vec2 way = to.p_px - from.p_px;
  const float length2 = glm::dot(way, way);
  return std::ranges::all_of(between, [&](const ScreenPoint& point) {
    const float s = length2 > 0 ? std::clamp(glm::dot(point.p_px - from.p_px, way) / length2, 0.0f, 1.0f) : 0.0f;
    const float behind = point.depth - glm::mix(from.depth, to.depth, s);
    return glm::distance(point.p_px, from.p_px + s * way) <= kOff_px &&
           std::abs(point.halfWidth_px - glm::mix(from.halfWidth_px, to.halfWidth_px, s)) <= kOff_px &&
           std::abs(behind) * camera.scale_px(point.depth) <= kOffAlongView_px;
  });
}

Run thinned(const draw::Camera& camera, const Run& run) {
  if (run.size() < 3) return run;
  const std::span<const ScreenPoint> all(run);
  Run kept{run.front()};
  std::size_t last = 0;
  for (std::size_t i = 1; i + 1 < run.size(); ++i) {
    const auto between = all.subspan(last + 1, i - last);
    if (between.size() <= kMostLeftOut && isStraight(camera, run[last], between, run[i + 1])) continue;
    kept.push_back(run[i]);
    last = i;
  }
  kept.push_back(run.back());
  return kept;
}

glm::vec2 direction(const ScreenPoint& a, const ScreenPoint& b) {
  const glm::vec2 d = b.p_px - a.p_px;
  const float length = glm::length(d);
  return length > 1e-6f ? d / length : glm::vec2(1, 0);
}

std::vector<Run> splitAtFolds(const Run& run) {
  std::vector<Run> pieces(1);
  for (std::size_t i = 0; i < run.size(); ++i) {
    pieces.back().push_back(run[i]);
    const bool inner = i > 0 && i + 1 < run.size();
    if (inner && glm::dot(direction(run[i - 1], run[i]), direction(run[i], run[i + 1])) < kFoldCosine)
      pieces.push_back({run[i]});
  }
  return pieces;
}

class StripBuilder {
 public:
  explicit StripBuilder(CurveStrip& strip) : strip_(strip) {}

  void add(Run run, bool closed) {
    if (run.size() < 2) return;
    // The vertices store the distance to the nearest end, and shaders interpolate it linearly. With a third point
    // the two ends lie in different pieces, so the interpolation is correct.
    if (run.size() == 2) run.insert(run.begin() + 1, midpoint(run[0], run[1]));
    pairs_.clear();
    const std::size_t n = run.size();
    if (!closed) addEnd(run[0], direction(run[0], run[1]), -1);
    for (std::size_t i = 0; i < n; ++i) addJoint(run, i, closed);
    if (!closed) addEnd(run[n - 1], direction(run[n - 2], run[n - 1]), 1);
    emitTriangles();
  }

 private:
  struct Pair {
    StripVertex left, right;
  };

  static ScreenPoint midpoint(const ScreenPoint& a, const ScreenPoint& b) {
    return {0.5f * (a.p_px + b.p_px), 0.5f * (a.halfWidth_px + b.halfWidth_px), 0.5f * (a.depth + b.depth),
            0.5f * (a.tangent_C + b.tangent_C)};
  }

  void addPair(const ScreenPoint& point, glm::vec2 centre_px, glm::vec2 mitre, float toEnd_px) {
    const float reach = point.halfWidth_px + kRamp_px;
    const auto vertex = [&](float side) {
      const glm::vec2 p = centre_px + side * reach * mitre;
      strip_.bounds.include(p, kRamp_px);
      return StripVertex{p, {side * reach, point.halfWidth_px, toEnd_px, point.depth}, point.tangent_C};
    };
    pairs_.push_back({vertex(1), vertex(-1)});
  }

  // Returns the direction to the left of `d` in the picture, where y points down. Offsets to the left are
  // positive.
  static glm::vec2 leftOf(glm::vec2 d) { return {d.y, -d.x}; }

  void addEnd(const ScreenPoint& point, glm::vec2 along, float outwards) {
    addPair(point, point.p_px + outwards * kRamp_px * along, leftOf(along), -kRamp_px);
  }

  void addJoint(const Run& run, std::size_t i, bool closed) {
    const std::size_t n = run.size();
    const bool first = i == 0, last = i + 1 == n;
    glm::vec2 in = first ? glm::vec2(0) : direction(run[i - 1], run[i]);
    glm::vec2 out = last ? glm::vec2(0) : direction(run[i], run[i + 1]);
    if (first) in = closed ? direction(run[n - 2], run[n - 1]) : out;
    if (last) out = closed ? direction(run[0], run[1]) : in;
    const glm::vec2 sum = in + out;
    const glm::vec2 along = glm::length(sum) > 1e-6f ? glm::normalize(sum) : in;
    // A mitre is longer than the half width by 1 / cos(half the bend): at most sqrt(2), as curves are cut at
    // folds.
    const float stretch = 1.0f / std::max(glm::dot(along, in), 0.7071f);
    const bool atEnd = !closed && (first || last);
    addPair(run[i], run[i].p_px, leftOf(along) * stretch, atEnd ? 0.0f : kEndless);
  }

  void emitTriangles() {
    for (std::size_t i = 0; i + 1 < pairs_.size(); ++i) {
      Pair a = pairs_[i], b = pairs_[i + 1];
      // Only the pieces next to an end store the true distance to that end. Elsewhere the end counts as far away.
      const float length = glm::distance(0.5f * (a.left.position_px + a.right.position_px),
                                         0.5f * (b.left.position_px + b.right.position_px));
      if (a.left.across.z >= kEndless && b.left.across.z < kEndless)
        a.left.across.z = a.right.across.z = b.left.across.z + length;
      if (b.left.across.z >= kEndless && a.left.across.z < kEndless)
        b.left.across.z = b.right.across.z = a.left.across.z + length;
      strip_.triangles.insert(strip_.triangles.end(), {a.left, a.right, b.left, b.left, a.right, b.right});
    }
  }

  CurveStrip& strip_;
  std::vector<Pair> pairs_;
};

}  // namespace

CurveStrip makeCurveStrip(const draw::Camera& camera, const draw::Curve& curve) {
  CurveStrip strip;
  if (curve.points_V.size() < 2) return strip;
  StripBuilder builder(strip);
  const auto runs = visibleRuns(camera, curve);
  for (const Run& run : runs) {
    const auto pieces = splitAtFolds(thinned(camera, run));
    const bool whole = curve.closed && runs.size() == 1 && pieces.size() == 1;
    for (const Run& piece : pieces) builder.add(piece, whole);
  }
  return strip;
}

}  // namespace poinsot::render
