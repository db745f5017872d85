// SPDX-License-Identifier: Apache-2.0
#include "stage/label_layout.h"

#include <gtest/gtest.h>

#include <random>

#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

struct Box {
  float left, top, right, bottom;
};

Box inkOf(const draw::Text& text) {
  const auto run = text::setTex(text.tex);
  const auto em = [&](double x) { return static_cast<float>(x) * text.size_px; };
  return {text.baseline_px.x + em(run.inkLeft_em), text.baseline_px.y - em(run.inkTop_em),
          text.baseline_px.x + em(run.inkRight_em), text.baseline_px.y - em(run.inkBottom_em)};
}

draw::DrawList picture() {
  draw::DrawList list;
  list.camera.size_px = {800, 450};
  return list;
}

TEST(LabelLayout, PutsALabelBesideItsAnchor) {
  draw::DrawList list = picture();
  addLabels(list, {{.tex = "$\\mathbf{L}$", .anchor_px = {400, 200}, .direction = {1, 0}, .gap_px = 10}}, {});
  const Box ink = inkOf(list.texts.at(0));
  EXPECT_NEAR(ink.left, 410, 0.5);
  EXPECT_NEAR(0.5f * (ink.top + ink.bottom), 200, 0.5);
}

TEST(LabelLayout, LabelsStayApartAndInside) {
  std::mt19937_64 engine(7);
  const auto uniform = [&](double most) {
    return static_cast<float>(most * static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  for (int trial = 0; trial < 300; ++trial) {
    draw::DrawList list = picture();
    std::vector<Label> labels;
    // Five labels around one place, as when a motion brings all arrows together.
    const glm::vec2 place(uniform(800), uniform(450));
    for (const char* tex : {"$\\mathbf{L}$", "$\\boldsymbol{\\omega}$", "$\\hat{\\mathbf{e}}_1$",
                            "$\\hat{\\mathbf{e}}_2$", "$\\hat{\\mathbf{e}}_3$"})
      labels.push_back({.tex = tex,
                        .anchor_px = place + glm::vec2(uniform(60), uniform(60)),
                        .direction = {uniform(2) - 1, uniform(2) - 1},
                        .gap_px = 8,
                        .size_px = 24});
    addLabels(list, labels, {});
    for (std::size_t i = 0; i < list.texts.size(); ++i) {
      const Box a = inkOf(list.texts[i]);
      EXPECT_GE(a.left, 0);
      EXPECT_GE(a.top, 0);
      EXPECT_LE(a.right, 800);
      EXPECT_LE(a.bottom, 450);
      for (std::size_t j = i + 1; j < list.texts.size(); ++j) {
        const Box b = inkOf(list.texts[j]);
        const bool apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
        EXPECT_TRUE(apart) << "trial " << trial << ": " << list.texts[i].tex << " and " << list.texts[j].tex;
      }
    }
  }
}

}  // namespace
}  // namespace poinsot::stage
