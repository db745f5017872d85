// SPDX-License-Identifier: Apache-2.0
#include "stage/type/crowded_text.h"

#include <algorithm>
#include <vector>

#include "stage/type/pixel_box.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

constexpr double kTextTolerance = 0.12;  // tolerated overlap, as a fraction of the text size

struct InkOfText {
  PixelBox box;  // without the tolerated border
  std::string plain;
};

void addInk(std::vector<InkOfText>& all, const draw::Text& text, glm::dvec2 origin_px) {
  const text::GlyphRun run = text::setTex(text.tex);
  if (run.glyphs.empty() || !(text.opacity > 0)) return;
  const double em = text.size_px, spare = 0.5 * kTextTolerance * em;
  const glm::dvec2 base = origin_px + glm::dvec2(text.baseline_px);
  all.push_back({{base.x + em * run.inkLeft_em + spare, base.y - em * run.inkTop_em + spare,
                  base.x + em * run.inkRight_em - spare, base.y - em * run.inkBottom_em - spare},
                 run.plainText});
}

bool liesIn(const PixelBox& box, glm::dvec2 size_px) {
  return box.left >= 0 && box.top >= 0 && box.right <= size_px.x && box.bottom <= size_px.y;
}

}  // namespace

std::string crowdedText(const draw::Picture& picture) {
  std::vector<InkOfText> all;
  for (const draw::Text& text : picture.texts) addInk(all, text, glm::dvec2(0));
  for (const draw::Panel& panel : picture.panels)
    for (const draw::Text& text : panel.list.texts) addInk(all, text, glm::dvec2(panel.origin_px));
  for (auto one = all.begin(); one != all.end(); ++one) {
    if (!liesIn(one->box, glm::dvec2(picture.size_px))) return one->plain;
    const auto before =
        std::find_if(all.begin(), one, [&](const auto& other) { return near(one->box, other.box); });
    if (before != one) return one->plain;
  }
  return "";
}

}  // namespace poinsot::stage
