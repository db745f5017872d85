// SPDX-License-Identifier: Apache-2.0
#include "stage/type/label_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "text/math_setter.h"

namespace poinsot::stage {

namespace {

constexpr int kRounds = 24;             // largest number of rounds of pushing labels apart; four labels need five
constexpr float kSpaceToShaft = 0.08f;  // gap to an arrow's shaft, as a fraction of the text size
// Gaps between labels, across and down, as fractions of the text size. Two names with a smaller gap look like a
// product.
constexpr glm::vec2 kApart{0.6f, 0.3f};
constexpr float kBorder = 0.012f;  // free border, as a fraction of the picture's shorter side
constexpr float kHalo = 0.085f;    // width of the halo, as a fraction of the text size

struct Placed {
  glm::vec2 centre_px;
  glm::vec2 half_px;
  glm::vec2 inkOffset_px;  // from the baseline's left end to the middle of the ink
};

glm::vec2 atMostUnit(glm::vec2 v) { return v / std::max(glm::length(v), 1.0f); }

Placed place(const Label& label) {
  const text::GlyphRun run = text::setTex(label.tex);
  const auto em = [&](double x) { return static_cast<float>(x) * label.size_px; };
  Placed placed;
  placed.half_px = 0.5f * glm::vec2(em(run.inkRight_em - run.inkLeft_em), em(run.inkTop_em - run.inkBottom_em));
  placed.inkOffset_px =
      0.5f * glm::vec2(em(run.inkLeft_em + run.inkRight_em), -em(run.inkTop_em + run.inkBottom_em));
  // Places the box of the ink in the preferred direction, so that it touches the circle of radius gap_px around
  // the anchor.
  const glm::vec2 d = atMostUnit(label.direction);
  placed.centre_px = label.anchor_px + d * label.gap_px + d * glm::abs(placed.half_px);
  return placed;
}

// Pushes two overlapping boxes apart along the axis of least overlap, by the fraction `share` of the overlap.
void separate(Placed& a, Placed& b, glm::vec2 space_px, float share) {
  const glm::vec2 between = b.centre_px - a.centre_px;
  const glm::vec2 overlap = a.half_px + b.half_px + space_px - glm::abs(between);
  if (overlap.x <= 0 || overlap.y <= 0) return;
  const int axis = overlap.x < overlap.y ? 0 : 1;
  const float push = 0.5f * share * overlap[axis] * (between[axis] < 0 ? -1.0f : 1.0f);
  a.centre_px[axis] -= push;
  b.centre_px[axis] += push;
}

// Moves a label off obstacles. Called only once, from the preferred position, because repeated pushes would grow
// to a jump when a shaft passes. Several shafts push at most twice as far as one shaft, so that a label stays near
// its own.
void moveOff(const std::vector<LabelObstacle>& obstacles, float space_px, Placed& p) {
  glm::vec2 sum(0);
  float longest_px = 0;
  for (const LabelObstacle& obstacle : obstacles) {
    const glm::vec2 push = pushOff(obstacle, p.centre_px, p.half_px, space_px);
    sum += push;
    longest_px = std::max(longest_px, glm::length(push));
  }
  const float length_px = glm::length(sum), most_px = 2 * longest_px;
  p.centre_px += length_px > most_px ? most_px / length_px * sum : sum;
}

// Moves a label out of a box, through the nearest side that faces the picture's middle. If the box contains the
// picture's middle, the label moves through the nearest of all sides.
void giveWay(Placed& p, const PixelBox& box, glm::vec2 size_px, float space_px) {
  const glm::vec2 low(box.left, box.top), high(box.right, box.bottom), middle = 0.5f * (low + high);
  const glm::vec2 reach = 0.5f * (high - low) + p.half_px + glm::vec2(space_px);
  const glm::vec2 away = p.centre_px - middle, inwards = 0.5f * size_px - middle;
  if (std::abs(away.x) >= reach.x || std::abs(away.y) >= reach.y) return;
  const bool central = glm::all(glm::lessThan(glm::abs(inwards), 0.5f * (high - low)));
  glm::vec2 towards = glm::sign(central ? away : inwards);
  if (central && towards.y == 0) towards.y = 1;
  const glm::vec2 push = reach - towards * away;
  const int axis = towards.y == 0 || (towards.x != 0 && push.x < push.y) ? 0 : 1;
  p.centre_px[axis] += towards[axis] * push[axis];
}

void keepInside(Placed& p, glm::vec2 size_px, float top_px) {
  const glm::vec2 free = p.half_px + glm::vec2(kBorder * std::min(size_px.x, size_px.y));
  const glm::vec2 low = glm::min(free + glm::vec2(0, top_px), 0.5f * size_px);
  p.centre_px = glm::clamp(p.centre_px, low, glm::max(size_px - free, 0.5f * size_px));
}

// Fades the labels of points outside the picture, instead of keeping such labels at the border.
std::vector<Label> ofWhatIsInThePicture(const std::vector<Label>& labels, glm::vec2 size_px) {
  std::vector<Label> seen;
  for (Label label : labels) {
    const glm::vec2 outside_px = glm::max(-label.anchor_px, label.anchor_px - size_px);
    const float there = std::clamp(1 - std::max(outside_px.x, outside_px.y) / label.size_px, 0.0f, 1.0f);
    label.presence = std::min(label.presence, there);
    label.opacity *= there;
    if (there > 0) seen.push_back(std::move(label));
  }
  return seen;
}

}  // namespace

glm::vec2 softUnit(glm::vec2 v, float soft) { return v / std::max(std::hypot(glm::length(v), soft), 1e-6f); }

void addLabels(draw::DrawList& list, const std::vector<Label>& all, const draw::Color& halo, float top_px,
               std::span<const PixelBox> taken) {
  const glm::vec2 size_px = list.camera.size_px;
  const std::vector<Label> labels = ofWhatIsInThePicture(all, size_px);
  std::vector<Placed> placed;
  for (const Label& label : labels) placed.push_back(place(label));
  const std::vector<LabelObstacle> obstacles = obstaclesOf(list);
  for (std::size_t i = 0; i < placed.size(); ++i) moveOff(obstacles, kSpaceToShaft * labels[i].size_px, placed[i]);
  const auto isWhereItWas = [](const Placed& a, const Placed& b) { return a.centre_px == b.centre_px; };
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Placed> before = placed;
    for (std::size_t i = 0; i < placed.size(); ++i)
      for (std::size_t j = i + 1; j < placed.size(); ++j)
        separate(placed[i], placed[j], kApart * labels[i].size_px,
                 std::min(labels[i].presence, labels[j].presence));
    for (std::size_t i = 0; i < placed.size(); ++i) {
      for (const PixelBox& box : taken) giveWay(placed[i], box, size_px, 0.3f * labels[i].size_px);
      keepInside(placed[i], size_px, top_px);
    }
    if (std::ranges::equal(placed, before, isWhereItWas)) break;
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    list.texts.push_back({label.tex, placed[i].centre_px - placed[i].inkOffset_px, label.size_px, label.color,
                          label.opacity, halo, kHalo * label.size_px});
  }
}

namespace {

constexpr float kTurningShare = 0.3f;  // fraction of the reach over which the push changes sides
constexpr float kShortest_px = 1;      // shorter shafts push no labels, because they point at the eye

float extent(glm::vec2 half_px, glm::vec2 direction) {
  return half_px.x * std::abs(direction.x) + half_px.y * std::abs(direction.y);
}

}  // namespace

std::vector<LabelObstacle> obstaclesOf(const draw::DrawList& list) {
  std::vector<LabelObstacle> obstacles;
  for (const draw::Curve& curve : list.curves) {
    if (curve.points_V.size() != 2 || !(curve.radius_V > 0)) continue;
    const float from = depthOf(list.camera, curve.points_V[0]), to = depthOf(list.camera, curve.points_V[1]);
    if (std::min(from, to) < list.camera.near) continue;
    obstacles.push_back({project(list.camera, curve.points_V[0]), project(list.camera, curve.points_V[1]),
                         curve.radius_V * list.camera.scale_px(0.5f * (from + to))});
  }
  return obstacles;
}

glm::vec2 pushOff(const LabelObstacle& obstacle, glm::vec2 centre_px, glm::vec2 half_px, float space_px) {
  const glm::vec2 whole = obstacle.to_px - obstacle.from_px;
  const float length = glm::length(whole);
  if (length < kShortest_px) return glm::vec2(0);
  const glm::vec2 along = whole / length, across(-along.y, along.x), at = centre_px - obstacle.from_px;
  const float aside = glm::dot(at, across), reach = extent(half_px, across) + obstacle.halfWidth_px + space_px;
  if (std::abs(aside) >= reach) return glm::vec2(0);
  const float beyond = std::max({0.0f, -glm::dot(at, along), glm::dot(at, along) - length});
  const float beside = std::clamp(1 - beyond / std::max(extent(half_px, along), 1e-3f), 0.0f, 1.0f);
  const float side = std::clamp(aside / (kTurningShare * reach), -1.0f, 1.0f);
  return beside * side * (reach - std::abs(aside)) * across;
}

}  // namespace poinsot::stage
