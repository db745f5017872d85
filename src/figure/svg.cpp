// SPDX-License-Identifier: Apache-2.0
// Writes SVG figures. Glyphs are drawn as outlines with <use>. The same text lies over them invisibly, so that it
// can be selected, searched and read aloud.
// An embedded web font could do both, but librsvg, Inkscape and Cairo ignore @font-face. They would use another
// font. With FigureOptions::svgText, the visible text is text, in fonts that the viewer's machine must have.
#include <fmt/format.h>

#include <set>
#include <utility>

#include "core/text.h"
#include "figure/ink.h"
#include "figure/mark.h"
#include "figure/parts.h"
#include "figure/svg_names.h"
#include "figure/svg_text.h"
#include "figure/writers.h"
#include "image/png_file.h"
#include "text/glyph_outline.h"
#include "text/math_setter.h"

namespace poinsot::figure {
namespace {

std::string base64(const Bytes& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * ((bytes.size() + 2) / 3));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? std::uint32_t{bytes[i + k]} : 0; };
    const std::uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[three >> shift & 63];
  }
  if (bytes.size() % 3 > 0)
    text.replace(text.size() - (3 - bytes.size() % 3), std::string::npos, 3 - bytes.size() % 3, '=');
  return text;
}

/// Escapes text for an element or an attribute. Control characters, which XML forbids, become spaces.
std::string escaped(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n') c = ' ';
  return core::xmlAttribute(text);
}

template <typename Points>
std::string pathData(const Points& points, bool closed) {
  std::string data;
  for (const auto& p : points)
    data += fmt::format("{}{} {}", data.empty() ? 'M' : 'L', number(static_cast<double>(p.x)),
                        number(static_cast<double>(p.y)));
  if (points.size() == 1) data += "h0";  // the round ends of a line without length make a dot
  return data + (closed ? "Z" : "");
}

/// Returns attributes such as `fill="#123456" fill-opacity="0.5"`. There is no opacity attribute for opaque ink.
std::string paintedBy(const char* what, const Ink& ink) {
  const std::string color = fmt::format(" {}=\"{}\"", what, hexOf(ink));
  return ink.alpha < 1 ? color + fmt::format(" {}-opacity=\"{}\"", what, number(ink.alpha)) : color;
}

/// Writes the outline of a glyph as SVG path data, in the font's units, y down. The data is empty for a space.
class PathWriter final : public text::OutlineSink {
 public:
  void moveTo(text::Point to) override {
    close();
    start_ = to;
    add('M', {to});
  }
  void lineTo(text::Point to) override {
    if (to.x != start_.x || to.y != start_.y) add('L', {to});  // otherwise the "Z" command draws this line
  }
  void cubicTo(text::Point c1, text::Point c2, text::Point end) override { add('C', {c1, c2, end}); }

  std::string data() {
    close();
    return data_;
  }

 private:
  void close() {
    if (!data_.empty()) data_ += 'Z';
  }
  void add(char command, std::initializer_list<text::Point> points) {
    data_ += command;
    for (const text::Point& p : points)
      data_ += fmt::format("{}{:.0f} {:.0f}", data_.back() == command ? "" : " ", p.x, 0 - p.y);  // no "-0"
  }

  std::string data_;
  text::Point start_;
};

using FontGlyph = std::pair<text::Typeface, text::GlyphId>;

std::string pathOf(const FontGlyph& glyph) {
  PathWriter path;
  text::traceGlyph(glyph.first, glyph.second, path);
  return path.data();
}

/// Returns an identifier for a glyph, from its font and its number in the font. Several figures may be embedded in
/// one page, and equal identifiers then stand for equal outlines.
std::string nameOf(const FontGlyph& glyph) {
  constexpr const char* kFonts[] = {"lmmath", "lmroman", "lmbold"};
  return fmt::format("{}-{}", kFonts[static_cast<int>(glyph.first)], glyph.second);
}

class SvgDocument {
 public:
  explicit SvgDocument(const Figure& figure) : figure_(figure), paper_(figure.picture.background) {}

  std::string write() {
    addImage();
    for (const PanelCurves& panel : curvesOf(figure_.picture)) add(panel);
    for (const draw::Area& area : figure_.picture.areas) add(area);
    addStrokes();
    body_ += fmt::format("<g id=\"{}\">\n", names_.take("labels"));
    for (const draw::Text& label : labelsOf(figure_.picture)) add(label);
    body_ += "</g>\n";
    return marked(kSvgMark, head() + glyphs() + body_ + "</svg>\n");
  }

 private:
  std::string head() const {
    const FigureOptions& options = figure_.options;
    const glm::ivec2 size = figure_.picture.size_px;
    std::string head = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" role=\"img\" "
        "width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\">\n",
        number(options.width_mm), number(options.width_mm * size.y / size.x), size.x, size.y);
    if (!options.title.empty()) head += fmt::format("<title>{}</title>\n", escaped(options.title));
    if (!options.description.empty()) head += fmt::format("<desc>{}</desc>\n", escaped(options.description));
    return head;
  }

  std::string glyphs() const {
    std::string defs = "<defs>\n";
    for (const FontGlyph& glyph : glyphs_)
      defs += fmt::format("<path id=\"{}\" d=\"{}\"/>\n", nameOf(glyph), pathOf(glyph));
    return defs + "</defs>\n";
  }

  void addImage() {
    body_ += fmt::format(
        "<image id=\"surfaces\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
        "xlink:href=\"data:image/png;base64,{}\"/>\n",
        figure_.picture.size_px.x, figure_.picture.size_px.y, base64(image::encodePng(figure_.imagePart)));
  }

  void add(const PanelCurves& panel) {
    const std::string name = fmt::format("view-{}", ++views_);
    if (panel.lines.empty()) return;
    body_ += fmt::format(
        "<svg id=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
        "stroke-linejoin=\"round\">\n",
        name, panel.origin_px.x, panel.origin_px.y, panel.size_px.x, panel.size_px.y);
    for (const SeenLine& line : panel.lines)
      body_ += fmt::format("<path{} stroke-width=\"{}\" d=\"{}\"/>\n",
                           paintedBy("stroke", inkOver(paper_, line.color, 1)), number(line.width_px),
                           pathData(line.points_px, line.closed));
    body_ += "</svg>\n";
  }

  void add(const draw::Area& area) {
    body_ += fmt::format("<path{} d=\"{}\"/>\n", paintedBy("fill", inkOver(paper_, area.color, area.opacity)),
                         pathData(area.points_px, true));
  }

  /// Adds the lines, with a group for each plot.
  void addStrokes() {
    int plot = 0;
    const auto enter = [&](int next) {
      if (next == plot) return;
      if (plot > 0) body_ += "</g>\n";
      if (next > 0) body_ += fmt::format("<g id=\"{}\">\n", names_.take(fmt::format("plot-{}", next)));
      plot = next;
    };
    for (const draw::Stroke& stroke : figure_.picture.strokes) {
      enter(stroke.plot);
      add(stroke);
    }
    enter(0);
  }

  void add(const draw::Stroke& stroke) {
    if (stroke.width_px <= 0 || stroke.points_px.empty()) return;
    const bool dashed = stroke.dash_px > stroke.width_px;
    body_ += fmt::format(
        "<path fill=\"none\"{} stroke-width=\"{}\" stroke-linejoin=\"round\" "
        "stroke-linecap=\"round\"{} d=\"{}\"/>\n",
        paintedBy("stroke", inkOver(paper_, stroke.color, stroke.opacity)),
        number(static_cast<double>(stroke.width_px)),
        dashed ? fmt::format(" stroke-dasharray=\"{}\"", number(static_cast<double>(stroke.dash_px))) : "",
        pathData(stroke.points_px, stroke.closed));
  }

  void add(const draw::Text& label) {
    const text::GlyphRun run = text::setTex(label.tex);
    const std::string word = wordOf(label.tex);
    body_ += fmt::format(
        "<g id=\"{}\" transform=\"translate({} {})\">\n", names_.take(word.empty() ? "label" : "label-" + word),
        number(static_cast<double>(label.baseline_px.x)), number(static_cast<double>(label.baseline_px.y)));
    if (figure_.options.svgText)
      addText(label, run);
    else
      addOutlines(label, run);
    body_ += "</g>\n";
  }

  /// Opens a group in thousandths of the label's em.
  void beginThousandths(double size_px) {
    body_ += fmt::format("<g transform=\"scale({:.6f})\">\n", size_px / 1000);
  }

  bool hasHalo(const draw::Text& label) const { return figure_.hasPaper() && label.halo && label.halo_px > 0; }

  void addHalo(const draw::Text& label, const text::GlyphRun& run) {
    if (!hasHalo(label)) return;
    const double width = 2000 * static_cast<double>(label.halo_px / label.size_px);
    addGlyphs(run, paintedBy("stroke", inkOver(paper_, *label.halo, label.opacity)) + " fill=\"none\"", width);
  }

  void addOutlines(const draw::Text& label, const text::GlyphRun& run) {
    beginThousandths(static_cast<double>(label.size_px));
    addHalo(label, run);
    addGlyphs(run, paintedBy("fill", inkOver(paper_, label.color, label.opacity)), 0);
    body_ += fmt::format(
        "<text font-family=\"serif\" font-size=\"1000\" fill-opacity=\"0\" textLength=\"{}\" "
        "lengthAdjust=\"spacingAndGlyphs\">{}</text>\n</g>\n",
        number(1000 * run.width_em), escaped(run.plainText));
  }

  /// Adds a label as text. Only its halo, its rules and the glyphs that no character gives are outlines.
  void addText(const draw::Text& label, const text::GlyphRun& run) {
    const double size_px = static_cast<double>(label.size_px);
    const SvgLine line = svgLine(run, size_px);
    const std::string fill = paintedBy("fill", inkOver(paper_, label.color, label.opacity));
    text::GlyphRun rest;
    rest.glyphs = line.rest;
    rest.rules = run.rules;
    const bool hasRest = !rest.glyphs.empty() || !rest.rules.empty();
    if (hasRest || hasHalo(label)) {
      beginThousandths(size_px);
      addHalo(label, run);
      if (hasRest) addGlyphs(rest, fill, 0);
      body_ += "</g>\n";
    }
    if (line.tspans.empty()) return;
    body_ += fmt::format(
        "<text xml:space=\"preserve\" text-rendering=\"geometricPrecision\" {} font-size=\"{}\"{}>{}</text>\n",
        svgTextFont(), number(size_px), fill, line.tspans);
  }

  // Adds glyphs, scaled to thousandths of the label's em. The scale of a script also shrinks the stroke of its
  // halo, so the stroke is widened.
  void addGlyphs(const text::GlyphRun& run, const std::string& paint, double strokeWidth) {
    body_ += fmt::format("<g aria-hidden=\"true\" stroke-linejoin=\"round\"{}>\n", paint);
    const auto stroke = [&](double scale) {
      return strokeWidth > 0 ? fmt::format(" stroke-width=\"{}\"", number(strokeWidth / scale)) : "";
    };
    for (const text::PlacedGlyph& g : run.glyphs) {
      const FontGlyph glyph(g.face, g.id);
      glyphs_.insert(glyph);
      const std::string scale = g.scale == 1 ? "" : fmt::format(" scale({})", number(g.scale));
      body_ += fmt::format("<use xlink:href=\"#{}\" transform=\"translate({} {}){}\"{}/>\n", nameOf(glyph),
                           number(1000 * g.x_em), number(-1000 * g.y_em), scale, stroke(g.scale));
    }
    for (const text::Rule& r : run.rules)
      body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", number(1000 * r.x_em),
                           number(-1000 * (r.y_em + r.height_em)), number(1000 * r.width_em),
                           number(1000 * r.height_em), stroke(1));
    body_ += "</g>\n";
  }

  const Figure& figure_;
  draw::Color paper_;
  std::set<FontGlyph> glyphs_;
  SvgNames names_;
  int views_ = 0;
  std::string body_;
};

}  // namespace

std::string svgOf(const Figure& figure) { return SvgDocument(figure).write(); }

}  // namespace poinsot::figure
