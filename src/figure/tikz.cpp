// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "figure/ink.h"
#include "figure/mark.h"
#include "figure/named_points.h"
#include "figure/parts.h"
#include "figure/tex.h"
#include "figure/writers.h"

namespace poinsot::figure {
namespace {

constexpr std::string_view kHead =
    R"(% The picture is {image}; LaTeX sets its labels in the fonts of the document.
% In the preamble: \usepackage{{tikz}} \usepackage{{amsmath}}. The labels' \boldsymbol is of amsmath; the package bm,
% loaded after it, sets bold Greek in more fonts.
% By itself: \documentclass{{standalone}} \usepackage{{tikz,amsmath}} \begin{{document}} \input{{NAME}} \end{{document}}
% From another folder: \graphicspath{{{{folder/}}}}. For larger or smaller labels: \newcommand*\poinsotscale{{1.2}}
% To draw over the picture, define a command before \input. It applies to the next picture only:
%   \newcommand\poinsotoverlay{{\draw[->] (0, 0) -- (poinsot-centre);}}
)";

/// Returns TeX code that makes ASCII symbols ordinary characters until the group ends, except TeX's own symbols.
/// Babel turns some symbols into commands, which breaks labels and TikZ options. Examples are " in German, : and ;
/// in French, and = in Turkish.
std::string ordinarySigns() {
  constexpr std::string_view kSigns[] = {"!\"'()*+,-./", ":;<=>?@[]`|"};
  std::string codes;
  for (const std::string_view line : kSigns) {
    for (const char sign : line) codes += fmt::format("\\catcode{} 12", static_cast<int>(sign));
    codes += "\\relax\n";
  }
  return codes + "\\catcode94 7\\catcode95 8\\relax\n";
}

std::string comment(std::string_view text) {
  std::string lines;
  for (bool more = !text.empty(); more;) {
    const std::size_t end = text.find('\n');
    more = end != text.npos;
    lines += fmt::format("% {}\n", text.substr(0, end));
    if (more) text.remove_prefix(end + 1);
  }
  std::erase(lines, '\r');
  return lines;
}

std::string colorOf(const Ink& ink) {
  const auto byte = [](double v) { return static_cast<int>(std::lround(255 * v)); };
  return fmt::format("{{rgb,255:red,{};green,{};blue,{}}}", byte(ink.srgb.r), byte(ink.srgb.g), byte(ink.srgb.b));
}

std::string node(const draw::Text& label, const std::string& latex, glm::dvec2 at_bp, const Figure& figure) {
  const Ink ink = inkOver(figure.picture.background, label.color, label.opacity);
  const std::string opacity = ink.alpha < 1 ? fmt::format(", text opacity={:.3f}", ink.alpha) : "";
  // Scales the 10 pt font to the label's size, as in the picture. A font of the actual size could have wider
  // letters, and some fonts do not exist in all sizes.
  const double scale = figure.pointsPerPixel() * static_cast<double>(label.size_px) / (10 * 72 / 72.27);
  return fmt::format(
      "  \\node[anchor=base west, inner sep=0pt, outer sep=0pt, scale={:.4f}*\\poinsotscale, "
      "font=\\fontsize{{10}}{{12}}\\selectfont,\n    text={}{}] at ({:.3f}bp, {:.3f}bp) {{{}}};\n",
      scale, colorOf(ink), opacity, at_bp.x, at_bp.y, latex);
}

std::string coordinates(const std::vector<PlacedPoint>& points, const Figure& figure) {
  const double scale = figure.pointsPerPixel(), height_px = figure.picture.size_px.y;
  std::string text;
  for (const PlacedPoint& point : points)
    text += fmt::format("  \\coordinate ({}) at ({:.3f}bp, {:.3f}bp);\n", point.name, scale * point.at_px.x,
                        scale * (height_px - point.at_px.y));
  return text;
}

/// Returns a comment that lists the coordinates, in lines of at most 100 characters.
std::string coordinatesComment(const std::vector<PlacedPoint>& points) {
  if (points.empty()) return "";
  constexpr std::size_t kLongestLine = 100;
  std::string text, line = "% Coordinates:";
  for (const PlacedPoint& point : points) {
    const std::string word = " (" + point.name + ")";
    if (line.size() + word.size() > kLongestLine) {
      text += line + "\n";
      line = "%  ";
    }
    line += word;
  }
  return text + line + "\n";
}

}  // namespace

std::string tikzOf(const Figure& figure, const std::string& imageName) {
  const glm::dvec2 size_bp = figure.pointsPerPixel() * glm::dvec2(figure.picture.size_px);
  const auto anchors = labelAnchors(figure.picture, FigureMedium::kTikz, figure.options);
  std::string nodes, all;
  std::size_t k = 0;
  for (const draw::Text& label : labelsOf(figure.picture)) {
    const std::string latex = latexOf(label.tex);
    nodes += node(label, latex, anchors[k++], figure);
    all += latex;
  }
  const std::vector<PlacedPoint> points = placedPoints(figure.picture, figure.pointsPerPixel());
  const std::string text =
      fmt::format(fmt::runtime(kHead), fmt::arg("image", imageName)) + coordinatesComment(points) +
      comment(figure.options.title) + comment(figure.options.description) + "\\begingroup\n" + ordinarySigns() +
      "\\providecommand*\\poinsotscale{1}%\n\\providecommand\\poinsotoverlay{}%\n" + latexDefinitionsFor(all) +
      fmt::format(
          "\\begin{{tikzpicture}}\n"
          "  \\path[use as bounding box] (0, 0) rectangle ({0:.3f}bp, {1:.3f}bp);\n"
          "  \\node[anchor=south west, inner sep=0pt, outer sep=0pt] at (0, 0)\n"
          "    {{\\includegraphics[width={0:.3f}bp, height={1:.3f}bp]{{{2}}}}};\n",
          size_bp.x, size_bp.y, imageName) +
      nodes + coordinates(points, figure) +
      "  \\poinsotoverlay\n\\end{tikzpicture}%\n\\endgroup\n"
      "\\global\\let\\poinsotoverlay\\undefined\n";
  return marked(kTexMark, text);
}

}  // namespace poinsot::figure
