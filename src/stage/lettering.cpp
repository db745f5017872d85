// SPDX-License-Identifier: Apache-2.0
#include "stage/lettering.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "stage/to_picture.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// In shares of the reference height.
constexpr double kHeading = 0.044, kUnderHeading = 0.028;
constexpr double kTitle = 0.042, kSubtitle = 0.03, kNote = 0.025, kEdge = 0.055;
constexpr double kLine = 2.0 / 1080;
// In points: a label as the text of a book's captions, and nothing that a copier would lose.
constexpr double kPrintedLabel = 8.5, kPrintedLine = 0.6, kLeastPrinted = 6.5;
// In em.
constexpr double kCapHeight = 0.7, kDescent = 0.2, kLeading = 0.3;

// 200000 as "200 000"; a number with decimals stays as it is.
std::string grouped(double x) {
  std::string digits = fmt::format("{:.15g}", x);
  if (digits.find_first_not_of("0123456789") != std::string::npos) return digits;
  for (auto i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), "\u2009");
  return digits;
}

}  // namespace

double referenceHeight(glm::vec2 size_px) {
  return std::min(static_cast<double>(size_px.y), static_cast<double>(size_px.x) * 9 / 16);
}

Sizing screenSizing(glm::vec2 size_px) {
  const double H = referenceHeight(size_px);
  return {H, kLine * H, 0};
}

Sizing printSizing(double pixelsPerInch) {
  const double point_px = pixelsPerInch / 72;
  return {kPrintedLabel / kLabelSize * point_px, kPrintedLine * point_px, kLeastPrinted * point_px};
}

Sizing typeScaled(const Sizing& sizing, double factor) {
  return {factor * sizing.type_px, sizing.line_px, factor * sizing.least_px};
}

double addTitle(draw::Picture& picture, const scene::Scene& scene, const Sizing& sizing, const Palette& colors) {
  const auto [H, line_px, least_px] = typeScaled(sizing, scene.style.textSize);
  const double left = kEdge * H, room = static_cast<double>(picture.size_px.x) - 2 * left;
  double y = kEdge * H;
  const auto addLine = [&](const std::string& tex, double size, const draw::Color& color) {
    const text::GlyphRun run = text::setTex(tex);
    // A line too long for the picture is set smaller.
    const double size_px = std::min(std::max(size * H, least_px), room / std::max(run.width_em, 1e-9));
    y += size_px * std::max(run.inkTop_em, kCapHeight);
    picture.texts.push_back({tex, glm::vec2(left, y), static_cast<float>(size_px), color, 1, std::nullopt, 0});
    y += size_px * (std::max(-run.inkBottom_em, kDescent) + kLeading);
  };
  if (!scene.show.title.empty()) addLine("\\textbf{" + scene.show.title + "}", kTitle, colors.ink);
  if (!scene.show.subtitle.empty()) addLine(scene.show.subtitle, kSubtitle, colors.quietInk);
  const double bottom = y > kEdge * H ? y : 0;
  // What is not to scale is said in the picture.
  y = static_cast<double>(picture.size_px.y) - (kEdge + kNote) * H;
  if (scene.show.exaggerateAngles > 1)
    addLine("angles drawn " + grouped(scene.show.exaggerateAngles) + " times larger", kNote, colors.quietInk);
  return bottom;
}

double addHeading(draw::Picture& picture, const Cell& cell, const scene::View& view, const Sizing& sizing,
                  const Palette& colors) {
  const auto width = static_cast<double>(cell.size_px.x), edge = 0.5 * kEdge * sizing.type_px;
  double y = edge;
  const auto addLine = [&](const std::string& tex, double size, const draw::Color& color) {
    const text::GlyphRun run = text::setTex(tex);
    const double room = std::max(width - 2 * edge, 1.0);
    const double wanted_px = std::max(size * sizing.type_px, sizing.least_px);
    const double size_px = std::min(wanted_px, room / std::max(run.width_em, 1e-9));
    y += size_px * std::max(run.inkTop_em, kCapHeight);
    const glm::vec2 baseline(0.5 * (width - size_px * run.width_em), y);
    picture.texts.push_back(
        {tex, glm::vec2(cell.origin_px) + baseline, static_cast<float>(size_px), color, 1, std::nullopt, 0});
    y += size_px * (std::max(-run.inkBottom_em, kDescent) + kLeading);
  };
  if (!view.title.empty()) addLine("\\textbf{" + view.title + "}", kHeading, colors.ink);
  if (!view.subtitle.empty()) addLine(view.subtitle, kUnderHeading, colors.quietInk);
  return y > edge ? y : 0;
}

}  // namespace poinsot::stage
