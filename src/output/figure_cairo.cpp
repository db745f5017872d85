// SPDX-License-Identifier: Apache-2.0
#include "output/figure_cairo.h"

#include <cairo-ft.h>
#include <cairo.h>
#include <fmt/format.h>

#include "core/error.h"
#include "text/font.h"

namespace poinsot::output {
namespace {

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using ContextPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using PathPtr = std::unique_ptr<cairo_path_t, decltype(&cairo_path_destroy)>;

constexpr double kUnits = 1000;  // to the em, as in the font itself: its points are whole numbers

char letterOf(cairo_path_data_type_t type) {
  switch (type) {
    case CAIRO_PATH_MOVE_TO:
      return 'M';
    case CAIRO_PATH_LINE_TO:
      return 'L';
    case CAIRO_PATH_CURVE_TO:
      return 'C';
    case CAIRO_PATH_CLOSE_PATH:
      break;
  }
  return 'Z';
}

std::string dataOf(const cairo_path_t& path) {
  std::string data;
  for (int i = 0; i < path.num_data; i += path.data[i].header.length) {
    const cairo_path_data_t* element = &path.data[i];
    data += letterOf(element->header.type);
    for (int k = 1; k < element->header.length; ++k)
      data += fmt::format("{}{:.0f} {:.0f}", k > 1 ? " " : "", element[k].point.x, element[k].point.y);
  }
  return data;
}

}  // namespace

std::shared_ptr<cairo_font_face_t> cairoFont() {
  FT_FaceRec_* face = text::Font::mathematics().face();
  return {cairo_ft_font_face_create_for_ft_face(face, 0), &cairo_font_face_destroy};
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

std::string svgPathOf(text::GlyphId id) {
  const SurfacePtr surface(cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr), &cairo_surface_destroy);
  const ContextPtr context(cairo_create(surface.get()), &cairo_destroy);
  const auto font = cairoFont();
  useFont(context.get(), font.get(), kUnits);
  const cairo_glyph_t glyph{id, 0, 0};
  cairo_glyph_path(context.get(), &glyph, 1);
  const PathPtr path(cairo_copy_path(context.get()), &cairo_path_destroy);
  if (path->status != CAIRO_STATUS_SUCCESS)
    throw core::Error(core::ErrorKind::kEncode,
                      fmt::format("cairo: outline of a glyph: {}", cairo_status_to_string(path->status)));
  return dataOf(*path);
}

}  // namespace poinsot::output
