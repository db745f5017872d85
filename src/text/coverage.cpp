// SPDX-License-Identifier: Apache-2.0
#include "text/coverage.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/expect.h"
#include "text/font.h"
#include "text/halo.h"

namespace poinsot::text {
namespace {

constexpr double kSubpixels = 64;  // FreeType's 26.6 coordinates

struct PixelBox {
  int left = std::numeric_limits<int>::max();
  int bottom = std::numeric_limits<int>::max();
  int right = std::numeric_limits<int>::min();
  int top = std::numeric_limits<int>::min();

  bool empty() const { return left >= right || bottom >= top; }
};

// One outline owned here, as FreeType's glyph slot holds only the last glyph.
class Outline {
 public:
  Outline(FT_Library library, int points, int contours) : library_(library) {
    POINSOT_EXPECT(FT_Outline_New(library, static_cast<FT_UInt>(points), contours, &outline_) == 0);
  }
  ~Outline() {
    if (library_ != nullptr) FT_Outline_Done(library_, &outline_);
  }
  Outline(Outline&& other) noexcept : library_(other.library_), outline_(other.outline_) {
    other.library_ = nullptr;
  }
  Outline(const Outline&) = delete;
  Outline& operator=(const Outline&) = delete;

  FT_Outline* get() { return &outline_; }

 private:
  FT_Library library_;
  FT_Outline outline_{};
};

// Where em lengths fall: in 1/64 pixel from the corner of the pixel that holds the origin, y up.
class Placement {
 public:
  Placement(double size_px, double originX_px, double originY_px)
      : wholeX_(std::floor(originX_px)),
        wholeY_(std::floor(originY_px)),
        fractionX_px_(originX_px - wholeX_),
        fractionY_px_(wholeY_ - originY_px),
        size_px_(size_px) {}

  FT_Vector at(double x_em, double y_em) const {
    return {nearest(fractionX_px_ + size_px_ * x_em), nearest(fractionY_px_ + size_px_ * y_em)};
  }
  int wholeX() const { return static_cast<int>(wholeX_); }
  int wholeY() const { return static_cast<int>(wholeY_); }

 private:
  static FT_Pos nearest(double px) { return static_cast<FT_Pos>(std::floor(kSubpixels * px + 0.5)); }

  double wholeX_;
  double wholeY_;
  double fractionX_px_;
  double fractionY_px_;
  double size_px_;
};

Outline glyphOutline(const PlacedGlyph& glyph, const Placement& placement) {
  const Font& font = Font::mathematics();
  constexpr FT_Int32 kUnscaled = FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP;
  POINSOT_EXPECT(FT_Load_Glyph(font.face(), glyph.id, kUnscaled) == 0);
  FT_Outline& source = font.face()->glyph->outline;
  Outline outline(font.library(), source.n_points, source.n_contours);
  FT_Outline_Copy(&source, outline.get());
  const double em = glyph.scale / font.unitsPerEm();
  for (int i = 0; i < source.n_points; ++i) {
    const FT_Vector& p = source.points[i];
    outline.get()->points[i] =
        placement.at(glyph.x_em + em * static_cast<double>(p.x), glyph.y_em + em * static_cast<double>(p.y));
  }
  return outline;
}

Outline ruleOutline(const Rule& rule, const Placement& placement) {
  Outline outline(Font::mathematics().library(), 4, 1);
  const double right = rule.x_em + rule.width_em;
  const double top = rule.y_em + rule.height_em;
  const FT_Vector corners[] = {placement.at(rule.x_em, rule.y_em), placement.at(right, rule.y_em),
                               placement.at(right, top), placement.at(rule.x_em, top)};
  for (int i = 0; i < 4; ++i) {
    outline.get()->points[i] = corners[i];
    outline.get()->tags[i] = FT_CURVE_TAG_ON;
  }
  outline.get()->contours[0] = 3;
  return outline;
}

std::vector<Outline> outlinesOf(const GlyphRun& run, const Placement& placement) {
  std::vector<Outline> outlines;
  for (const PlacedGlyph& glyph : run.glyphs) outlines.push_back(glyphOutline(glyph, placement));
  for (const Rule& rule : run.rules) outlines.push_back(ruleOutline(rule, placement));
  return outlines;
}

PixelBox boxOf(std::vector<Outline>& outlines) {
  PixelBox box;
  for (Outline& outline : outlines) {
    if (outline.get()->n_points == 0) continue;  // a space
    FT_BBox ink;
    FT_Outline_Get_CBox(outline.get(), &ink);
    box.left = std::min(box.left, static_cast<int>(ink.xMin >> 6));
    box.bottom = std::min(box.bottom, static_cast<int>(ink.yMin >> 6));
    box.right = std::max(box.right, static_cast<int>((ink.xMax + 63) >> 6));
    box.top = std::max(box.top, static_cast<int>((ink.yMax + 63) >> 6));
  }
  return box;
}

// Receives FreeType's spans: adds them to the map, full at most, so that overlapping shapes do not wrap round.
struct SpanTarget {
  CoverageMap* map;
  int topRow;  // y, upwards, of the row above the map's first

  static void add(int y, int count, const FT_Span* spans, void* user) {
    const auto& target = *static_cast<SpanTarget*>(user);
    std::uint8_t* row =
        target.map->values.data() + static_cast<std::ptrdiff_t>(target.topRow - 1 - y) * target.map->width;
    for (const FT_Span* span = spans; span != spans + count; ++span)
      for (int x = span->x; x < span->x + span->len; ++x)
        row[x] = static_cast<std::uint8_t>(std::min(255, row[x] + span->coverage));
  }
};

void fill(Outline& outline, CoverageMap& map, const PixelBox& box) {
  FT_Outline_Translate(outline.get(), -box.left * 64L, 0);
  SpanTarget target{&map, box.top};
  FT_Raster_Params params{};
  params.source = outline.get();
  params.flags = FT_RASTER_FLAG_AA | FT_RASTER_FLAG_DIRECT | FT_RASTER_FLAG_CLIP;
  params.gray_spans = &SpanTarget::add;
  params.user = &target;
  params.clip_box = {0, box.bottom, map.width, box.top};
  POINSOT_EXPECT(FT_Outline_Render(Font::mathematics().library(), outline.get(), &params) == 0);
}

// The outline as straight pieces, in pixels of the map, y down.
class Flattener {
 public:
  Flattener(HaloBuilder& halo, int topRow) : halo_(halo), topRow_(topRow) {}

  void trace(Outline& outline) {
    FT_Outline_Funcs funcs{};
    funcs.move_to = [](const FT_Vector* to, void* self) { return static_cast<Flattener*>(self)->moveTo(*to); };
    funcs.line_to = [](const FT_Vector* to, void* self) { return static_cast<Flattener*>(self)->lineTo(*to); };
    funcs.conic_to = [](const FT_Vector* c, const FT_Vector* to, void* self) {
      return static_cast<Flattener*>(self)->conicTo(*c, *to);
    };
    funcs.cubic_to = [](const FT_Vector* c1, const FT_Vector* c2, const FT_Vector* to, void* self) {
      return static_cast<Flattener*>(self)->cubicTo(*c1, *c2, *to);
    };
    POINSOT_EXPECT(FT_Outline_Decompose(outline.get(), &funcs, this) == 0);
  }

 private:
  Point pixel(const FT_Vector& v) const {
    return {static_cast<double>(v.x) / kSubpixels, topRow_ - static_cast<double>(v.y) / kSubpixels};
  }
  int moveTo(const FT_Vector& to) {
    pen_ = pixel(to);
    return 0;
  }
  int lineTo(const FT_Vector& to) { return lineTo(pixel(to)); }
  int lineTo(Point to) {
    halo_.addSegment(pen_, to);
    pen_ = to;
    return 0;
  }
  int conicTo(const FT_Vector& control, const FT_Vector& end) {
    const Point p = pen_, c = pixel(control), q = pixel(end);
    return cubicTo(p + (c - p) * (2.0 / 3), q + (c - q) * (2.0 / 3), q);
  }
  int cubicTo(const FT_Vector& c1, const FT_Vector& c2, const FT_Vector& to) {
    return cubicTo(pixel(c1), pixel(c2), pixel(to));
  }
  int cubicTo(Point c1, Point c2, Point end) {
    const Point start = pen_;
    // A quarter circle of radius r in n chords is off by 0.31 r / n²; with n² = 4 pixels of length 0.05 pixel.
    const double length = distance(start, c1) + distance(c1, c2) + distance(c2, end);
    const int pieces = 1 + static_cast<int>(2 * std::sqrt(length));
    for (int i = 1; i <= pieces; ++i) {
      const double t = static_cast<double>(i) / pieces, s = 1 - t;
      lineTo(start * (s * s * s) + c1 * (3 * s * s * t) + c2 * (3 * s * t * t) + end * (t * t * t));
    }
    return 0;
  }

  HaloBuilder& halo_;
  int topRow_;
  Point pen_;
};

}  // namespace

std::uint8_t CoverageMap::at(int x, int y) const {
  const int column = x - left, row = y - top;
  if (column < 0 || row < 0 || column >= width || row >= height) return 0;
  return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column)];
}

CoverageMap rasterize(const GlyphRun& run, double size_px, double originX_px, double originY_px,
                      double outline_px) {
  POINSOT_EXPECT(size_px > 0 && size_px <= 4000);
  POINSOT_EXPECT(outline_px >= 0 && outline_px <= 200);
  POINSOT_EXPECT(std::abs(originX_px) <= 1e6 && std::abs(originY_px) <= 1e6);
  const Placement placement(size_px, originX_px, originY_px);
  std::vector<Outline> outlines = outlinesOf(run, placement);
  PixelBox box = boxOf(outlines);
  if (box.empty()) return {};
  const int margin = outline_px > 0 ? static_cast<int>(std::ceil(outline_px)) + 1 : 0;
  box = {box.left - margin, box.bottom - margin, box.right + margin, box.top + margin};

  CoverageMap map;
  map.left = placement.wholeX() + box.left;
  map.top = placement.wholeY() - box.top;
  map.width = box.right - box.left;
  map.height = box.top - box.bottom;
  map.values.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height), 0);
  for (Outline& outline : outlines) fill(outline, map, box);
  if (outline_px == 0) return map;

  HaloBuilder halo(map.width, map.height, outline_px);
  Flattener flattener(halo, box.top);
  for (Outline& outline : outlines) flattener.trace(outline);
  halo.growInto(map.values);
  return map;
}

}  // namespace poinsot::text
