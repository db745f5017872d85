// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_pieces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace poinsot::figure {
namespace {

constexpr double kStep_px = 1.0;  // distance of samples along a line; smaller gaps in visibility are not found
constexpr double kCut_px = 0.1;
// Length by which pieces of different colour overlap. Without an overlap, their soft ends would be visible.
constexpr double kOverlap_px = 0.3;
constexpr int kColorSteps = 2;  // largest error of a piece's colour, in steps of 1/255 in sRGB

struct Sample {
  glm::dvec3 p_V{0};
  PiecePoint at;
  Sight sight;
  draw::Color seen{0};  ///< colour of the curve as the eye sees it through the sheets in front
};

using Run = std::vector<Sample>;

bool alike(const Sample& a, const Sample& b) {
  return a.sight.hidden == b.sight.hidden && (a.sight.hidden || a.sight.sheets == b.sight.sheets);
}

bool alike(const draw::Color& a, const draw::Color& b) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(draw::srgb8FromLinear(a[i]) - draw::srgb8FromLinear(b[i])) > kColorSteps) return false;
  return true;
}

class Sampler {
 public:
  Sampler(const Visibility& visibility, const draw::Camera& camera, const draw::Curve& curve)
      : visibility_(visibility), camera_(camera), curve_(curve) {}

  /// Returns the parts of the curve in front of the camera. Segments with an end nearer than camera.near are left
  /// out.
  std::vector<Run> runs() {
    const std::size_t n = curve_.points_V.size(), segments = curve_.closed ? n : n - 1;
    std::vector<Run> runs;
    bool joined = false;
    for (std::size_t i = 0; i < segments; ++i) {
      const glm::dvec3 from_V = curve_.points_V[i], to_V = curve_.points_V[(i + 1) % n];
      const bool seen = inFront(from_V) && inFront(to_V);
      if (seen && !joined) runs.push_back({sample(from_V)});
      if (seen) addSegment(runs.back(), from_V, to_V);
      joined = seen;
    }
    return runs;
  }

 private:
  bool inFront(glm::dvec3 p_V) const {
    return -toCameraExactly(camera_, p_V).z > static_cast<double>(camera_.near);
  }
  glm::dvec2 pixel(glm::dvec3 p_V) const { return projectExactly(camera_, toCameraExactly(camera_, p_V)); }

  Sample sample(glm::dvec3 p_V) const {
    const double lift = static_cast<double>(curve_.lift_V);
    const double depth = -toCameraExactly(camera_, p_V).z - lift;
    Sample s{p_V, {pixel(p_V), depth}, visibility_.of(p_V, lift), {}};
    s.seen = draw::Color(s.sight.veil + s.sight.transmittance * glm::dvec3(curve_.material.color));
    return s;
  }

  void addSegment(Run& run, glm::dvec3 from_V, glm::dvec3 to_V) const {
    const double length_px = glm::distance(pixel(from_V), pixel(to_V));
    const int steps = std::max(1, static_cast<int>(std::ceil(length_px / kStep_px)));
    for (int k = 1; k <= steps; ++k) {
      const Sample next = sample(glm::mix(from_V, to_V, static_cast<double>(k) / steps));
      if (!alike(run.back(), next)) addChange(run, next);
      run.push_back(next);
    }
  }

  // Finds the point between the last sample and `next` at which visibility changes. Adds a sample on either side.
  void addChange(Run& run, const Sample& next) const {
    Sample before = run.back(), after = next;
    while (glm::distance(before.at.p_px, after.at.p_px) > kCut_px) {
      const Sample middle = sample(0.5 * (before.p_V + after.p_V));
      (alike(before, middle) ? before : after) = middle;
    }
    run.insert(run.end(), {before, after});
  }

  const Visibility& visibility_;
  const draw::Camera& camera_;
  const draw::Curve& curve_;
};

PiecePoint reachedBack(const PiecePoint& from, const PiecePoint& before) {
  const double gap = glm::distance(before.p_px, from.p_px);
  const double reach = gap > 0 ? std::max(1.0, kOverlap_px / gap) : 0;
  return {from.p_px + reach * (before.p_px - from.p_px), before.depth};
}

void addPieces(const Run& run, double width_px, std::vector<Piece>& pieces) {
  bool open = false;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const Sample& s = run[i];
    const bool goesOn = open && !s.sight.hidden && alike(pieces.back().color, s.seen);
    if (!s.sight.hidden && !goesOn) {
      pieces.push_back({{}, false, width_px, s.seen});
      if (open) pieces.back().points.push_back(reachedBack(s.at, run[i - 1].at));
    }
    open = !s.sight.hidden;
    if (open) pieces.back().points.push_back(s.at);
  }
}

// Joins the first and the last piece of a closed curve, if the curve is visible at its start.
void joinEnds(std::vector<Piece>& pieces) {
  Piece &first = pieces.front(), &last = pieces.back();
  if (!alike(first.color, last.color)) return;
  if (pieces.size() == 1) {
    first.points.pop_back();
    first.closed = true;
    return;
  }
  last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
  first = std::move(last);
  pieces.pop_back();
}

}  // namespace

std::vector<Piece> visiblePieces(const Visibility& visibility, const draw::Camera& camera,
                                 const draw::Curve& curve) {
  std::vector<Piece> pieces;
  if (curve.radius_V > 0 || curve.points_V.size() < 2) return pieces;
  const std::vector<Run> runs = Sampler(visibility, camera, curve).runs();
  for (const Run& run : runs) addPieces(run, static_cast<double>(curve.width_px), pieces);
  const bool startIsSeen = curve.closed && runs.size() == 1 && !runs[0].front().sight.hidden;
  if (startIsSeen && runs[0].back().at.p_px == runs[0].front().at.p_px) joinEnds(pieces);
  std::erase_if(pieces, [](const Piece& piece) { return piece.points.size() < 2; });
  return pieces;
}

}  // namespace poinsot::figure
