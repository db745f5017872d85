// SPDX-License-Identifier: Apache-2.0
#include "stage/label_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

constexpr int kRounds = 24;        // of pushing overlapping labels apart; four labels settle in five
constexpr float kBorder = 0.012f;  // kept free, as a share of the picture's shorter side
constexpr float kHalo = 0.085f;    // of the type size

struct Placed {
  glm::vec2 centre_px;
  glm::vec2 half_px;
  glm::vec2 inkOffset_px;  // from the baseline's left end to the middle of the ink
};

glm::vec2 unit(glm::vec2 v) {
  const float length = glm::length(v);
  return length > 1e-3f ? v / length : glm::vec2(0, -1);
}

Placed place(const Label& label) {
  const text::GlyphRun run = text::setTex(label.tex);
  const auto em = [&](double x) { return static_cast<float>(x) * label.size_px; };
  Placed placed;
  placed.half_px = 0.5f * glm::vec2(em(run.inkRight_em - run.inkLeft_em), em(run.inkTop_em - run.inkBottom_em));
  placed.inkOffset_px =
      0.5f * glm::vec2(em(run.inkLeft_em + run.inkRight_em), -em(run.inkTop_em + run.inkBottom_em));
  // The ink's box touches the circle of radius gap around the anchor from outside, in the wished direction.
  const glm::vec2 d = unit(label.direction);
  placed.centre_px = label.anchor_px + d * label.gap_px + d * glm::abs(placed.half_px);
  return placed;
}

// Pushes two overlapping boxes apart along the axis where they overlap least.
void separate(Placed& a, Placed& b, float space_px) {
  const glm::vec2 between = b.centre_px - a.centre_px;
  const glm::vec2 overlap = a.half_px + b.half_px + glm::vec2(space_px) - glm::abs(between);
  if (overlap.x <= 0 || overlap.y <= 0) return;
  const int axis = overlap.x < overlap.y ? 0 : 1;
  const float push = 0.5f * overlap[axis] * (between[axis] < 0 ? -1.0f : 1.0f);
  a.centre_px[axis] -= push;
  b.centre_px[axis] += push;
}

void keepInside(Placed& p, glm::vec2 size_px, float top_px) {
  const glm::vec2 free = p.half_px + glm::vec2(kBorder * std::min(size_px.x, size_px.y));
  const glm::vec2 low = glm::min(free + glm::vec2(0, top_px), 0.5f * size_px);
  p.centre_px = glm::clamp(p.centre_px, low, glm::max(size_px - free, 0.5f * size_px));
}

}  // namespace

void addLabels(draw::DrawList& list, const std::vector<Label>& labels, const draw::Color& halo, float top_px) {
  std::vector<Placed> placed;
  for (const Label& label : labels) placed.push_back(place(label));
  const glm::vec2 size_px = list.camera.size_px;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < placed.size(); ++i)
      for (std::size_t j = i + 1; j < placed.size(); ++j) separate(placed[i], placed[j], 0.3f * labels[i].size_px);
    for (Placed& p : placed) keepInside(p, size_px, top_px);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    list.texts.push_back({label.tex, placed[i].centre_px - placed[i].inkOffset_px, label.size_px, label.color,
                          label.opacity, halo, kHalo * label.size_px});
  }
}

}  // namespace poinsot::stage
