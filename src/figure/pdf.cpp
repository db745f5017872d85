// SPDX-License-Identifier: Apache-2.0
#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <span>
#include <string_view>

#include "core/error.h"
#include "core/text.h"
#include "figure/ink.h"
#include "figure/mark.h"
#include "figure/parts.h"
#include "figure/writers.h"
#include "text/font.h"
#include "text/math_setter.h"
#include "text/plain_text.h"

namespace poinsot::figure {
namespace {

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using ContextPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using FontPtr = std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)>;

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw core::encodeError(fmt::format("writing a PDF: {}", cairo_status_to_string(status)));
}

cairo_status_t append(void* to, const unsigned char* data, unsigned size) noexcept try {
  auto* bytes = static_cast<Bytes*>(to);
  bytes->insert(bytes->end(), data, data + size);
  return CAIRO_STATUS_SUCCESS;
} catch (const std::bad_alloc&) {
  return CAIRO_STATUS_NO_MEMORY;
}

/// Image in cairo's format: a native 32-bit number per pixel, alpha in the top byte, colours multiplied by alpha.
class CairoImage {
 public:
  explicit CairoImage(const image::Image& image)
      : surface_(cairo_image_surface_create(image.channels == 4 ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
                                            image.size.width, image.size.height),
                 &cairo_surface_destroy) {
    check(cairo_surface_status(surface_.get()));
    unsigned char* rows = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < image.size.height; ++y)
      for (int x = 0; x < image.size.width; ++x) {
        const std::uint32_t pixel = packed(image.at(x, y), image.channels);
        std::memcpy(rows + static_cast<std::ptrdiff_t>(y) * stride + std::ptrdiff_t{4} * x, &pixel, sizeof(pixel));
      }
    cairo_surface_mark_dirty(surface_.get());
  }

  cairo_surface_t* surface() const { return surface_.get(); }

 private:
  static std::uint32_t packed(const std::uint8_t* p, int channels) {
    const std::uint32_t alpha = channels == 4 ? p[3] : 255;
    const auto times = [&](std::uint32_t c) { return (c * alpha + 127) / 255; };
    return alpha << 24 | times(p[0]) << 16 | times(p[1]) << 8 | times(p[2]);
  }

  SurfacePtr surface_;
};

/// Returns cairo's object for an embedded font, which only the calling thread may use.
FontPtr cairoFont(text::Typeface face) {
  return {cairo_ft_font_face_create_for_ft_face(text::Font::of(face).face(), 0), &cairo_font_face_destroy};
}

void useFont(cairo_t* context, cairo_font_face_t* font, double size) {
  const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> exact(
      cairo_font_options_create(), &cairo_font_options_destroy);
  cairo_font_options_set_hint_style(exact.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(exact.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_face(context, font);
  cairo_set_font_options(context, exact.get());
  cairo_set_font_size(context, size);
}

class Page {
 public:
  Page(cairo_t* context, const Figure& figure)
      : context_(context), paper_(figure.picture.background), halos_(figure.hasPaper()) {}

  void paint(const image::Image& image) {
    const CairoImage pixels(image);
    cairo_set_source_surface(context_, pixels.surface(), 0, 0);
    cairo_paint(context_);
  }

  void paint(const PanelCurves& panel) {
    cairo_save(context_);
    cairo_rectangle(context_, panel.origin_px.x, panel.origin_px.y, panel.size_px.x, panel.size_px.y);
    cairo_clip(context_);
    cairo_translate(context_, panel.origin_px.x, panel.origin_px.y);
    cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(context_, CAIRO_LINE_CAP_BUTT);
    for (const SeenLine& line : panel.lines) {
      use(inkOver(paper_, line.color, 1));
      outline(line.points_px, line.closed);
      cairo_set_line_width(context_, line.width_px);
      cairo_stroke(context_);
    }
    cairo_restore(context_);
  }

  void paint(const draw::Area& area) {
    use(inkOver(paper_, area.color, area.opacity));
    outline(area.points_px, true);
    cairo_fill(context_);
  }

  void paint(const draw::Stroke& stroke) {
    if (stroke.width_px <= 0 || stroke.points_px.empty()) return;
    use(inkOver(paper_, stroke.color, stroke.opacity));
    outline(stroke.points_px, stroke.closed);
    const double dash = static_cast<double>(stroke.dash_px);
    cairo_set_dash(context_, &dash, stroke.dash_px > stroke.width_px ? 1 : 0, 0);
    strokeRound(static_cast<double>(stroke.width_px));
    cairo_set_dash(context_, nullptr, 0, 0);
  }

  void paint(const draw::Text& text) {
    const text::GlyphRun run = text::setTex(text.tex);
    if (halos_ && text.halo && text.halo_px > 0) paintHalo(text, run);
    use(inkOver(paper_, text.color, text.opacity));
    for (auto begin = run.glyphs.begin(); begin != run.glyphs.end();) {
      const auto end = std::find_if(begin, run.glyphs.end(), [&](const text::PlacedGlyph& g) {
        return g.scale != begin->scale || g.face != begin->face;
      });
      show({begin, end}, text);
      begin = end;
    }
    addRules(text, run);
    cairo_fill(context_);
  }

 private:
  void use(const Ink& ink) { cairo_set_source_rgba(context_, ink.srgb.r, ink.srgb.g, ink.srgb.b, ink.alpha); }

  template <typename Points>
  void outline(const Points& points, bool closed) {
    for (const auto& p : points) cairo_line_to(context_, static_cast<double>(p.x), static_cast<double>(p.y));
    // cairo draws the round dot of a single point only if a line leads back to the point.
    if (points.size() == 1)
      cairo_line_to(context_, static_cast<double>(points[0].x), static_cast<double>(points[0].y));
    if (closed) cairo_close_path(context_);
  }

  void strokeRound(double width) {
    cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_width(context_, width);
    cairo_stroke(context_);
  }

  static cairo_glyph_t placed(const text::PlacedGlyph& glyph, const draw::Text& text) {
    const double size = static_cast<double>(text.size_px);
    return {glyph.id, static_cast<double>(text.baseline_px.x) + size * glyph.x_em,
            static_cast<double>(text.baseline_px.y) - size * glyph.y_em};
  }

  cairo_font_face_t* fontOf(text::Typeface face) {
    const auto known = fonts_.find(face);
    return (known != fonts_.end() ? known : fonts_.emplace(face, cairoFont(face)).first)->second.get();
  }

  // Draws glyphs of one font and size. Each glyph has the text that it stands for.
  void show(std::span<const text::PlacedGlyph> run, const draw::Text& text) {
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;
    std::string plain;
    for (const text::PlacedGlyph& glyph : run) {
      const std::string meaning = text::toUtf8(glyph.plain);
      glyphs.push_back(placed(glyph, text));
      clusters.push_back({static_cast<int>(meaning.size()), 1});
      plain += meaning;
    }
    useFont(context_, fontOf(run.front().face), static_cast<double>(text.size_px) * run.front().scale);
    cairo_show_text_glyphs(context_, plain.data(), static_cast<int>(plain.size()), glyphs.data(),
                           static_cast<int>(glyphs.size()), clusters.data(), static_cast<int>(clusters.size()),
                           cairo_text_cluster_flags_t{});
  }

  void addRules(const draw::Text& text, const text::GlyphRun& run) {
    const double size = static_cast<double>(text.size_px);
    for (const text::Rule& rule : run.rules)
      cairo_rectangle(context_, static_cast<double>(text.baseline_px.x) + size * rule.x_em,
                      static_cast<double>(text.baseline_px.y) - size * (rule.y_em + rule.height_em),
                      size * rule.width_em, size * rule.height_em);
  }

  void paintHalo(const draw::Text& text, const text::GlyphRun& run) {
    for (const text::PlacedGlyph& glyph : run.glyphs) {
      useFont(context_, fontOf(glyph.face), static_cast<double>(text.size_px) * glyph.scale);
      const cairo_glyph_t at = placed(glyph, text);
      cairo_glyph_path(context_, &at, 1);
    }
    addRules(text, run);
    use(inkOver(paper_, *text.halo, text.opacity));
    strokeRound(2 * static_cast<double>(text.halo_px));
  }

  cairo_t* context_;
  draw::Color paper_;
  bool halos_;
  std::map<text::Typeface, FontPtr> fonts_;
};

/// Placeholder for the date. If no date is set, cairo writes the current time, which would differ between runs.
/// The placeholder is later overwritten with spaces, which keeps all offsets in the file.
constexpr const char* kAnyDate = "1970-01-01T00:00:00Z";

void eraseDate(Bytes& pdf) {
  // A title cannot contain this text, because PDF escapes the bracket "(" in titles.
  constexpr std::string_view kEntry = "/CreationDate (";
  const auto begin = std::search(pdf.begin(), pdf.end(), kEntry.begin(), kEntry.end());
  const auto end = std::find(begin, pdf.end(), ')');
  if (end != pdf.end()) std::fill(begin, end + 1, ' ');
}

/// Throws if the PDF is incomplete. If memory for a font runs out, cairo 1.16 stops writing but reports success.
void checkEnd(const Bytes& pdf) {
  constexpr std::string_view kEnd = "%%EOF\n";
  if (pdf.size() < kEnd.size() || !std::equal(kEnd.rbegin(), kEnd.rend(), pdf.rbegin()))
    check(CAIRO_STATUS_NO_MEMORY);
}

void setMetadata(cairo_surface_t* surface, const FigureOptions& options) {
  const auto set = [&](cairo_pdf_metadata_t which, const std::string& value) {
    if (!value.empty()) cairo_pdf_surface_set_metadata(surface, which, value.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, options.title);
  set(CAIRO_PDF_METADATA_SUBJECT, options.description);
  set(CAIRO_PDF_METADATA_CREATOR, creator());
  set(CAIRO_PDF_METADATA_CREATE_DATE, kAnyDate);
}

}  // namespace

Bytes pdfOf(const Figure& figure) {
  const double scale = figure.pointsPerPixel();
  Bytes bytes;
  const SurfacePtr surface(cairo_pdf_surface_create_for_stream(append, &bytes, scale * figure.picture.size_px.x,
                                                               scale * figure.picture.size_px.y),
                           &cairo_surface_destroy);
  check(cairo_surface_status(surface.get()));
  // All viewers and printers can read PDF 1.4. Its metadata are not compressed, so mark.cpp can read them.
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
  setMetadata(surface.get(), figure.options);
  const ContextPtr context(cairo_create(surface.get()), &cairo_destroy);
  cairo_scale(context.get(), scale, scale);

  Page page(context.get(), figure);
  page.paint(figure.imagePart);
  for (const PanelCurves& panel : curvesOf(figure.picture)) page.paint(panel);
  for (const draw::Area& area : figure.picture.areas) page.paint(area);
  for (const draw::Stroke& stroke : figure.picture.strokes) page.paint(stroke);
  for (const draw::Text& label : labelsOf(figure.picture)) page.paint(label);
  check(cairo_status(context.get()));
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  checkEnd(bytes);
  eraseDate(bytes);
  return bytes;
}

}  // namespace poinsot::figure
