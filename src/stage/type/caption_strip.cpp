// SPDX-License-Identifier: Apache-2.0
#include "stage/type/caption_strip.h"

#include <algorithm>

#include "scene/motion/eased_track.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

constexpr double kSize = 0.037;  // text size as a fraction of Sizing::type_px, between title and subtitle
constexpr double kRoom = 0.88;   // largest width of a caption, as a fraction of the picture's width
constexpr double kBelow = 0.03;  // free room below the lines, as a fraction of Sizing::type_px
constexpr double kAbove = 0.01;  // free room above the lines, as a fraction of Sizing::type_px
constexpr double kCapHeight = 0.7, kDescent = 0.2, kLeading = 0.28;
constexpr double kIn_s = 0.5, kOut_s = 0.3;  // times to fade in and out; a caption is gone before the next comes

/// Returns the positions at which a line may be broken: spaces outside formulas and braces.
std::vector<std::size_t> breaksIn(const std::string& tex) {
  std::vector<std::size_t> places;
  int depth = 0;
  bool formula = false;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    if (tex[i] == '\\') {
      ++i;  // skips an escaped character
      continue;
    }
    if (tex[i] == '$') formula = !formula;
    if (tex[i] == '{') ++depth;
    if (tex[i] == '}') --depth;
    if (tex[i] == ' ' && !formula && depth == 0) places.push_back(i);
  }
  return places;
}

}  // namespace

CaptionStrip::CaptionStrip(const scene::Scene& scene)
    : duration_s_(scene.time.duration_s), shown_(scene.show.captions) {
  for (const scene::Caption& caption : scene.timeline.captions)
    entries_.push_back({caption, lineOf(caption.text), halvesOf(caption.text)});
}

CaptionStrip::Line CaptionStrip::lineOf(const std::string& tex) {
  const text::GlyphRun run = text::setTex(tex);
  return {tex, run.width_em, std::max(run.inkTop_em, kCapHeight), std::max(-run.inkBottom_em, kDescent)};
}

// Chooses the break that makes the longer line shortest.
std::optional<std::array<CaptionStrip::Line, 2>> CaptionStrip::halvesOf(const std::string& tex) {
  std::optional<std::array<Line, 2>> best;
  const auto width = [](const std::array<Line, 2>& lines) {
    return std::max(lines[0].width_em, lines[1].width_em);
  };
  for (const std::size_t place : breaksIn(tex)) {
    const std::array<Line, 2> lines = {lineOf(tex.substr(0, place)), lineOf(tex.substr(place + 1))};
    if (!best || width(lines) < width(*best)) best = lines;
  }
  return best;
}

std::vector<CaptionStrip::Line> CaptionStrip::linesOf(const Entry& entry, double room_em) {
  if (entry.whole.width_em <= room_em || !entry.halves) return {entry.whole};
  return {entry.halves->begin(), entry.halves->end()};
}

double CaptionStrip::height_em(const std::vector<Line>& lines) {
  double height = kLeading * static_cast<double>(lines.size() - 1);
  for (const Line& line : lines) height += line.top_em + line.bottom_em;
  return height;
}

double CaptionStrip::height_px(glm::vec2 size_px, const Sizing& sizing) const {
  if (!isDrawn(sizing)) return 0;
  const double em_px = smallSize_px(kSize, sizing), room_em = kRoom * size_px.x / em_px;
  double tallest = 0;
  for (const Entry& entry : entries_) tallest = std::max(tallest, height_em(linesOf(entry, room_em)));
  return tallest > 0 ? em_px * tallest + (kAbove + kBelow) * sizing.type_px : 0;
}

double CaptionStrip::opacity(const scene::Caption& caption, const Moment& moment) const {
  const double t_s = moment.filmTime_s;
  if (moment.still) return t_s >= caption.from_s && (t_s < caption.to_s || caption.to_s >= duration_s_) ? 1 : 0;
  const double third_s = (caption.to_s - caption.from_s) / 3, out_s = std::min(kOut_s, third_s);
  scene::EasedTrack track(caption.from_s > 0 ? 0 : 1);
  track.turnTo(caption.from_s, std::min(kIn_s, third_s), 1);
  if (caption.to_s < duration_s_) track.turnTo(caption.to_s - out_s, out_s, 0);
  return track.at(t_s);
}

void CaptionStrip::add(draw::Picture& picture, const Moment& moment, const Sizing& sizing,
                       const Palette& colors) const {
  if (!isDrawn(sizing)) return;
  const auto entry =
      std::ranges::find_if(entries_, [&](const Entry& e) { return opacity(e.caption, moment) > 0; });
  if (entry == entries_.end()) return;
  const double wanted_px = smallSize_px(kSize, sizing), room_px = kRoom * picture.size_px.x;
  const std::vector<Line> lines = linesOf(*entry, room_px / wanted_px);
  double widest = 0;
  for (const Line& line : lines) widest = std::max(widest, line.width_em);
  const double em_px = std::min(wanted_px, room_px / widest);  // smaller if the text is too long for two lines
  double y = picture.size_px.y - height_px(picture.size_px, sizing) + kAbove * sizing.type_px;
  for (const Line& line : lines) {
    y += em_px * line.top_em;
    picture.texts.push_back({line.tex, glm::vec2(0.5 * (picture.size_px.x - em_px * line.width_em), y),
                             static_cast<float>(em_px), colors.ink,
                             static_cast<float>(opacity(entry->caption, moment)), std::nullopt, 0});
    y += em_px * (line.bottom_em + kLeading);
  }
}

}  // namespace poinsot::stage
