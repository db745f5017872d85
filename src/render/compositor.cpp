// SPDX-License-Identifier: Apache-2.0
#include "render/compositor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/cells.h"
#include "render/constants.h"
#include "render/mosaic.h"
#include "render/sheet_constants.h"
#include "render/solid_pass.h"

namespace poinsot::render {
namespace {

void bindLayers(const gl::ShaderProgram& program, const SolidLayers& solids) {
  const gl::Framebuffer &full = solids[SolidLayer::kFull], &edge = solids[SolidLayer::kEdge],
                        &nextEdge = solids[SolidLayer::kNextEdge];
  const std::array<std::pair<const char*, GLuint>, 6> textures{{{"solidColor", full.color(0)},
                                                                {"solidDepth", full.depth()},
                                                                {"edgeColor", edge.color(0)},
                                                                {"edgeDepth", edge.depth()},
                                                                {"nextEdgeColor", nextEdge.color(0)},
                                                                {"nextEdgeDepth", nextEdge.depth()}}};
  for (std::size_t i = 0; i < textures.size(); ++i) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    glBindTexture(GL_TEXTURE_RECTANGLE, textures[i].second);
    program.set(textures[i].first, static_cast<int>(i));
  }
}

std::string kindsOf(const SheetCounts& sheets) {
  return fmt::format(
      "#define ELLIPSOIDS {}\n#define OF_ELLIPSOID {}\n#define PLANES {}\n#define OF_PLANE {}\n"
      "#define CONES {}\n#define OF_CONE {}\n#define POLYGONS {}\n#define OF_POLYGON {}\n#define SIDES {}\n",
      sheets.ellipsoids, kEllipsoidConstants, sheets.planes, kPlaneConstants, sheets.cones, kConeConstants,
      sheets.polygons, polygonConstants(sheets.polygonSides), sheets.polygonSides);
}

std::string each(const char* name, std::size_t from, std::size_t to) {
  std::string text = fmt::format("#define EACH_{}(f)", name);
  for (std::size_t i = from; i < to; ++i) text += fmt::format(" f({})", i);
  return text + "\n";
}

/// Returns macros that replace the loops of composite.frag by one call for each index.
std::string unrolled(const SheetCounts& sheets, std::size_t edges) {
  const std::size_t all = edges + sheets.fragments();
  std::string pairs = "#define EACH_PAIR(f)";
  for (std::size_t i = 0; i < all; ++i)
    for (std::size_t j = i + 1; j < all; ++j) pairs += fmt::format(" f({}, {})", i, j);
  return each("ELLIPSOID", 0, sheets.ellipsoids) + each("PLANE", 0, sheets.planes) +
         each("CONE", 0, sheets.cones) + each("POLYGON", 0, sheets.polygons) +
         each("SIDE", 0, sheets.polygonSides) + each("SHEET", edges, all) + each("FRAGMENT", 0, all) + pairs +
         "\n";
}

}  // namespace

const gl::ShaderProgram& Compositor::program(const Variant& variant) {
  if (const auto known = programs_.find(variant); known != programs_.end()) return known->second;
  const auto& [transparent, solids, outlines, sheets] = variant;
  const int reach = static_cast<int>(solids);
  const std::string defines = fmt::format("#define TRANSPARENT {:d}\n#define SOLIDS {}\n#define OUTLINES {:d}\n",
                                          transparent, reach, outlines);
  gl::ShaderProgram made = programWithConstants(
      "squares.vert", "composite.frag", 1 + sheets.constants(),
      defines + kindsOf(sheets) + unrolled(sheets, static_cast<std::size_t>(std::max(reach - 1, 0))));
  return programs_.emplace(variant, std::move(made)).first->second;
}

void Compositor::draw(const draw::DrawList& list, const SolidLayers& layers, const Sheets& sheets,
                      const Mosaic& mosaic, float sharpness, bool transparent) {
  const PictureConstants ofPicture = pictureConstants(list, sharpness, layers.origin_px());
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  floatAttribute(0, 3, sizeof(Square), 0);
  for (const auto& [content, parts] : mosaic.parts) {
    const SheetChoice& chosen = content.sheets;
    const auto& shader = program({transparent, content.solids, chosen.outlines, sheets.counts(chosen)});
    Constants own{{list.background, 0}};
    const Constants ofSheets = sheets.constants(chosen);
    own.insert(own.end(), ofSheets.begin(), ofSheets.end());
    useWith(shader, ofPicture, own);
    if (content.solids != SolidReach::kNone) bindLayers(shader, layers);
    std::vector<Square> squares;
    for (const PixelBounds& part : parts) addSquares(squares, part);
    upload(GL_ARRAY_BUFFER, buffer_, squares, GL_STREAM_DRAW);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(squares.size()));
  }
}

}  // namespace poinsot::render
