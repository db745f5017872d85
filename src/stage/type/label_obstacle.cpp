// SPDX-License-Identifier: Apache-2.0
#include "stage/type/label_obstacle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace poinsot::stage {
namespace {

constexpr float kTurningShare = 0.3f;  // of the reach, over which the push changes sides
constexpr float kShortest_px = 1;      // a shaft that points at the eye has no sides

float extent(glm::vec2 half_px, glm::vec2 direction) {
  return half_px.x * std::abs(direction.x) + half_px.y * std::abs(direction.y);
}

}  // namespace

std::vector<LabelObstacle> obstaclesOf(const draw::DrawList& list) {
  std::vector<LabelObstacle> obstacles;
  for (const draw::Curve& curve : list.curves) {
    if (curve.points_W.size() != 2 || !(curve.radius_W > 0)) continue;
    const float from = depthOf(list.camera, curve.points_W[0]), to = depthOf(list.camera, curve.points_W[1]);
    if (std::min(from, to) < list.camera.near) continue;
    obstacles.push_back({project(list.camera, curve.points_W[0]), project(list.camera, curve.points_W[1]),
                         curve.radius_W * list.camera.scale_px(0.5f * (from + to))});
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
